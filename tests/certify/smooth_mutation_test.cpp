// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 4: wrong claims are rejected. Every mutant has the right digests for what it says. One that
// is accepted may have another witness (a moved vertex, another direction), but what it states
// about the surface must be what the original states.
#include <catch2/catch.hpp>
#include <iostream>
#include <map>

#include "certify/container/container.hpp"
#include "certify/ridges_smooth/decode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/mutants.hpp"
#include "tests/certify/second_opinion.hpp"
#include "tests/certify/smooth_mutants.hpp"
#include "tests/certify/smooth_producer.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/program.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Original {
  std::string name;
  RidgesSmoothCertificate certificate;
  Bytes bytes;
};

RidgesSmoothCertificate decoded(const Bytes& bytes) {
  const Container container = open_container(bytes);
  return decode_ridges_smooth(container.data, container.claims);
}

/// Of the tests' own producer; and one of kind 0 from crest where it is built.
const std::vector<Original>& originals() {
  static const std::vector<Original> all = [] {
    std::vector<Original> out;
    for (auto& [name, c] : smooth_claims()) out.push_back({name, c, encode(c)});
#ifdef CREST_PROGRAM
    const TemporaryFolder folder;
    const auto run = run_shell(std::string(CREST_PROGRAM) +
                                   " ridges --quiet --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box "
                                   "'-3,3' --certificate e.crest",
                               folder.path(), ".");
    REQUIRE(run.exit_code == 0);
    const Bytes bytes = read_file((folder / "e.crest").string());
    out.push_back({"ellipsoid", decoded(bytes), bytes});
#endif
    for (const Original& o : out) {
      INFO(o.name << ": " << verify(o.bytes).reason);
      REQUIRE(verify(o.bytes).accepted);
    }
    return out;
  }();
  return all;
}

struct Tally {
  SecondOpinions second{20};
  std::uint64_t mutants = 0, accepted = 0, wrong = 0;
  std::map<std::string, std::uint64_t> reasons;

  void judge(const Original& original, const std::string& what, const Bytes& mutant) {
    ++mutants;
    const Verdict verdict = verify(mutant);
    ++reasons[verdict.reason.substr(0, verdict.reason.find_first_of(" :0123456789"))];
    const bool also = second.compare(mutant, verdict, original.name + ": " + what);
    if (!verdict.accepted && !also) return;
    ++accepted;
    const bool same = same_results(original.certificate, decoded(mutant));
    INFO(original.name << ": " << what);
    CHECK(same);
    wrong += !same;
  }
  void print(const char* what) const {
    std::cout << what << ": " << mutants << " mutants, " << accepted << " accepted, " << wrong
              << " of them with other results; rejected:";
    for (const auto& [reason, count] : reasons)
      if (!reason.empty()) std::cout << " " << reason << " " << count;
    std::cout << "\n";
  }
};

}  // namespace

TEST_CASE("edited records of smooth ridges are rejected, or state the same") {
  Random random(kSeed);
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(1000); ++i) {
    const Original& original = originals()[random() % originals().size()];
    RidgesSmoothCertificate c = original.certificate;
    const std::string what = mutate_smooth_claim(c, random);
    const Bytes mutant = encode(c);
    if (mutant != original.bytes) tally.judge(original, what, mutant);
  }
  tally.print("smooth ridges, edited records");
  CHECK(tally.wrong == 0);
  CHECK(tally.mutants > scaled(1000) / 2);
  CHECK(tally.accepted * 3 < tally.mutants);
}

TEST_CASE("edited bytes of smooth ridges, bound again, are rejected, or state the same") {
  Random random(kSeed + 1);
  Tally tally;
  for (std::uint64_t i = 0; i < scaled(1000); ++i) {
    const Original& original = originals()[random() % originals().size()];
    Bytes mutant = mutate_bytes(original.bytes, random);
    if (mutant == original.bytes) continue;
    try {
      rebind(mutant);
    } catch (const std::invalid_argument&) {
      continue;
    }
    if (mutant != original.bytes)
      tally.judge(original, difference_in_words(original.bytes, mutant), mutant);
  }
  tally.print("smooth ridges, edited bytes");
  CHECK(tally.wrong == 0);
}

TEST_CASE("garbage and truncated certificates of smooth ridges are rejected without harm") {
  Random random(kSeed + 2);
  SecondOpinions second(40);
  const auto refuse = [&](Bytes bytes) {
    try {
      rebind(bytes);
    } catch (const std::invalid_argument&) {
    }
    const Verdict verdict = verify(bytes);
    return !second.compare(bytes, verdict, "garbage") && !verdict.accepted;
  };
  for (const Original& original : originals()) {
    const Bytes& bytes = original.bytes;
    for (std::size_t n = 0; n < bytes.size(); n += n < 400 ? 1 : 1 + bytes.size() / 50)
      CHECK(refuse(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n))));
    for (std::uint64_t i = 0; i < scaled(300); ++i) {
      // A good start with a random rest, or with counts as large as can be.
      Bytes wild = bytes;
      const std::size_t keep = kHeaderSize + random() % (wild.size() - kHeaderSize - 2 * kSealSize);
      for (std::size_t k = keep; k < wild.size(); ++k)
        wild[k] = static_cast<std::uint8_t>(i % 3 == 0 ? 0xff : random());
      CHECK(refuse(wild));
    }
  }
}
