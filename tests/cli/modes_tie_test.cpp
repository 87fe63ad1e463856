// SPDX-License-Identifier: GPL-3.0-or-later
// crest-verify --input: the certificates of crest modes are tied to the file of the tensors.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

/// Two tetrahedra; the last tensor's xy is given.
std::string solids(const std::string& xy) {
  return "# vtk DataFile Version 3.0\ntwo\nASCII\nDATASET UNSTRUCTURED_GRID\n"
         "POINTS 5 double\n0 0 0  1 0 0  0 1 0  0 0 1  1 1 1\n"
         "CELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10 10\n"
         "POINT_DATA 5\nFIELD f 1\nstress 6 5 double\n"
         "3 1 -4 2 5 1\n-2 7 1 -3 2 2\n5 -1 3 4 -6 2\n-3 -3 7 1 1 -5\n2 6 -5 " +
         xy + " 3 -2\n";
}

}  // namespace

TEST_CASE("crest-verify --input: modes' certificates are those of the file, and of no other") {
  const TemporaryFolder folder;
  write_text(folder / "a.vtk", solids("1"));
  write_text(folder / "b.vtk", solids("2"));
  for (const std::string what : {"--degenerate", "--mode 0.5 --neutral"}) {
    CAPTURE(what);
    const auto made = run_crest("crest modes a.vtk --certificate c.crest " + what, folder.path());
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
    const auto same = run_crest("crest-verify c.crest --input a.vtk", folder.path());
    INFO(same.err);
    CHECK(same.exit_code == 0);
    CHECK(same.out.find("input: a.vtk holds the same positions, tetrahedra and tensors") !=
          std::string::npos);
    const auto named =
        run_crest("crest-verify c.crest --input a.vtk --tensor stress", folder.path());
    CHECK(named.exit_code == 0);
    for (const std::string other : {"b.vtk", "a.vtk --order 'xx xy xz yy yz zz'"}) {
      const auto verdict = run_crest("crest-verify c.crest --input " + other, folder.path());
      CHECK(verdict.exit_code == 1);
      CHECK(verdict.out.find("REJECTED: ") != std::string::npos);
      CHECK(verdict.out.find(", their digest is ") != std::string::npos);
    }
    for (const std::string none : {"c.vtk", "c.crest", "a.vtk --tensor strain"}) {
      const auto verdict = run_crest("crest-verify c.crest --input " + none, folder.path());
      CHECK(verdict.exit_code == 3);
      CHECK(is_one_line(verdict.err));
    }
  }
}
