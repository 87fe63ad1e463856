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
       {"crest::ridges::", "crest::sampling::", "crest::io::", "crest::cli::"}) {
    INFO(space);
    CHECK(mentions(producer, space));
    CHECK_FALSE(mentions(checker, space));
  }
  CHECK(mentions(checker, "crest::certify::"));
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
