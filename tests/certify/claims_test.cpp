// SPDX-License-Identifier: GPL-3.0-or-later
// The table of claims that CMake makes from the folders, against SPEC.md's.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "certify/container/compose.hpp"
#include "certify/verify.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace crest::certify;
namespace fs = std::filesystem;

}  // namespace

TEST_CASE("every claim has a number, a name, a room and a row in SPEC.md of its own") {
  const fs::path folder = fs::path(CREST_SOURCE_DIR) / "certify";
  const std::string spec = crest::tests::read_text(folder / "SPEC.md");
  std::set<std::uint32_t> numbers;
  std::set<std::string> names;
  for (const ClaimChecker* claim : known_claims()) {
    const std::string name = claim->name;
    INFO(claim->number << " " << name);
    std::string room = name;
    std::replace(room.begin(), room.end(), '-', '_');
    CHECK(numbers.insert(claim->number).second);
    CHECK(names.insert(name).second);
    const std::string row = "| " + std::to_string(claim->number) + " " + name + " | [" + room +
                            "/SPEC.md](" + room + "/SPEC.md) | ";
    CHECK(spec.find(row) != std::string::npos);
    CHECK(spec.find("`crest-verify-" + name + "`") != std::string::npos);
    for (const char* file : {"SPEC.md", "records.hpp", "encode.hpp", "decode.hpp", "claim.cpp"})
      CHECK(fs::exists(folder / room / file));
  }
  std::size_t rooms = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    rooms += fs::exists(entry.path() / "claim.cpp");
  CHECK(numbers.size() == rooms);
}

TEST_CASE("a claim that the program is not linked with is named, beside those it knows") {
  const auto nothing = [](ByteWriter&) {};
  const Verdict all = verify(compose({99, 1}, 0, nothing, nothing));
  CHECK_FALSE(all.accepted);
  CHECK(all.reason.rfind("claim 99 is not known here (known: ", 0) == 0);
  for (const ClaimChecker* claim : known_claims()) {
    INFO(claim->name);
    const auto entry = std::to_string(claim->number) + " " + claim->name;
    CHECK(all.reason.find(entry) != std::string::npos);
    const std::array others = {claim};
    const Bytes bytes = compose({claim->number + 1, claim->version}, 0, nothing, nothing);
    const Verdict one = verify_among(others, bytes, {});
    CHECK(one.reason == "claim " + std::to_string(claim->number + 1) +
                            " is not known here (known: " + entry + ")");
  }
}

TEST_CASE("each claim has a version of its own, the one that its SPEC.md states") {
  const fs::path folder = fs::path(CREST_SOURCE_DIR) / "certify";
  const auto nothing = [](ByteWriter&) {};
  for (const ClaimChecker* claim : known_claims()) {
    const std::string name = claim->name;
    INFO(name);
    std::string room = name;
    std::replace(room.begin(), room.end(), '-', '_');
    const std::string spec = crest::tests::read_text(folder / room / "SPEC.md");
    CHECK(spec.find("Version " + std::to_string(claim->version) + ". ") != std::string::npos);
    for (const std::uint32_t version : {claim->version - 1, claim->version + 1}) {
      const Verdict verdict = verify(compose({claim->number, version}, 0, nothing, nothing));
      CHECK(verdict.reason == "version " + std::to_string(version) + " of " + name +
                                  " is not known here (known: " + std::to_string(claim->version) +
                                  ")");
    }
  }
}
