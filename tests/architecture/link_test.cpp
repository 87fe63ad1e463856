// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs are linked from: the checker holds nothing of the systems, of io or of VTK.
#ifdef CREST_VERIFY_PROGRAM
#include <catch2/catch.hpp>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

std::string output_of(const std::string& line) {
  const TemporaryFolder folder;
  const ProgramResult result = run_shell(line, folder.path(), "/usr/bin");
  INFO(line << "\n" << result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

bool mentions(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("crest-verify holds no symbol of the systems, io or cli's report") {
  const std::string checker = output_of(std::string("nm -C '") + CREST_VERIFY_PROGRAM + "'");
  const std::string producer = output_of(std::string("nm -C '") + CREST_PROGRAM + "'");
  // The names are those the linker knows: the producer has them.
  for (const char* space :
       {"crest::ridges::", "crest::sampling::", "crest::io::", "crest::cli::Report"}) {
    INFO(space);
    CHECK(mentions(producer, space));
    CHECK_FALSE(mentions(checker, space));
  }
  CHECK(mentions(checker, "crest::certify::"));
}

TEST_CASE("crest-verify-reeb and its like hold their own claim alone") {
  std::vector<std::string> rooms;
  for (const auto& entry : fs::directory_iterator(fs::path(CREST_SOURCE_DIR) / "certify"))
    if (fs::exists(entry.path() / "claim.cpp")) rooms.push_back(entry.path().filename().string());
  REQUIRE(rooms.size() >= 4);
  const std::string all = output_of(std::string("nm -C '") + CREST_VERIFY_PROGRAM + "'");
  for (const std::string& room : rooms) {
    INFO(room);
    CHECK(mentions(all, "crest::certify::" + room + "_claim\n"));
    std::string name = room;
    std::replace(name.begin(), name.end(), '_', '-');
    const std::string path = CREST_VERIFY_PROGRAM + ("-" + name);
    const std::string one = output_of("nm -C '" + path + "'");
    for (const std::string& other : rooms)
      CHECK(mentions(one, "crest::certify::" + other + "_claim\n") == (other == room));
    // Claims 3 and 4 have namespaces of their own.
    CHECK(mentions(one, "crest::certify::reeb::") == (room == "reeb"));
    CHECK(mentions(one, "crest::certify::smooth::") == (room == "ridges_smooth"));
    CHECK(mentions(one, "crest::kernel::Expression") == (room == "ridges_smooth"));
    CHECK(mentions(output_of("'" + path + "' --help"), "Claims: " + name + ".\n"));
  }
}

TEST_CASE("crest-verify loads neither VTK nor TBB") {
  const std::string checker = output_of(std::string("ldd '") + CREST_VERIFY_PROGRAM + "'");
  const std::string producer = output_of(std::string("ldd '") + CREST_PROGRAM + "'");
  for (const char* library : {"libvtk", "libtbb"}) {
    INFO(library);
    CHECK(mentions(producer, library));
    CHECK_FALSE(mentions(checker, library));
  }
}
#endif
