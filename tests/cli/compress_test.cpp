// SPDX-License-Identifier: GPL-3.0-or-later
// crest compress as a user runs it: a generated field, its certificate, and what is refused.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

TEST_CASE("crest compress: report, picture and an accepted certificate") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample lattice --parameters 40,1 --seed 2 -o s.vtu", folder.path())
              .exit_code == 0);
  const auto run = run_crest(
      "crest compress s.vtu -o a.vtu --picture a.svg --report a.json --certificate a.crest --cite",
      folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{roessl2005surfaces,") != std::string::npos);
  const auto report = read_json(folder / "a.json");
  CHECK(report["same_skeleton"] == true);
  CHECK(report["equivalence"] == "original");
  CHECK(report["triangles_before"] == 3000);
  CHECK(report["triangles_after"] < 600);
  CHECK(report["skeleton"]["separatrices"]["count"] == 72);
  CHECK(report["certificate"]["certified"] == true);
  const auto verify = run_crest("crest-verify a.crest", folder.path());
  INFO(verify.out << verify.err);
  CHECK(verify.exit_code == 0);

  // The file that was written has the skeleton that the report has.
  REQUIRE(run_crest("crest skeleton a.vtu --report b.json", folder.path()).exit_code == 0);
  const auto again = read_json(folder / "b.json");
  CHECK(again["triangles"] == report["triangles_after"]);
  CHECK(again["separatrices"]["ends"] == report["skeleton"]["separatrices"]["ends"]);
  CHECK(again["critical_points"]["items"] == report["skeleton"]["critical_points"]["items"]);
}

TEST_CASE("crest compress: what it cannot take") {
  const TemporaryFolder folder;
  write_text(folder / "empty.vtk", "");
  const auto run = run_crest("crest compress empty.vtk -o out.vtu", folder.path());
  CHECK(run.exit_code == 3);
  CHECK(is_one_line(run.err));
  CHECK_FALSE(fs::exists(folder / "out.vtu"));
  CHECK(run_crest("crest compress empty.vtk --equivalence weak", folder.path()).exit_code == 2);
}
