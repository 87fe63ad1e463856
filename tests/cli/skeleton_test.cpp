// SPDX-License-Identifier: GPL-3.0-or-later
// crest skeleton as a user runs it: a generated field, every kind of input, and what is refused.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

/// Two triangles with vectors, as legacy VTK; `points` and `last` differ from case to case.
std::string two_triangles(const std::string& points, const std::string& cells,
                          const std::string& last) {
  return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n" + points +
         "\nPOLYGONS 2 8\n" + cells + "\nPOINT_DATA 4\nVECTORS v double\n1 0 0  0 1 0  -1 1 0\n" +
         last + "\n";
}
constexpr const char* kSquare = "0 0 0  1 0 0  1 1 0  0 1 0";
constexpr const char* kCells = "3 0 1 2\n3 0 2 3";

struct SkeletonCase {
  const char* name;
  std::string text;
  const char* words;
};

}  // namespace

TEST_CASE("crest skeleton: report, picture and an accepted certificate") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample lattice --parameters 40,1 --seed 1 -o s.vtu", folder.path())
              .exit_code == 0);
  const auto run = run_crest(
      "crest skeleton s.vtu -o a.vtp --picture a.svg --report a.json --certificate a.crest --cite",
      folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{roessl2005surfaces,") != std::string::npos);
  const auto report = read_json(folder / "a.json");
  CHECK(report["critical_points"]["saddles"] == 4);
  CHECK(report["critical_points"]["foci"] == 2);
  CHECK(report["boundary_switch_points"]["interior"] == 12);
  CHECK(report["index_sum"] == 2);
  CHECK(report["winding_sum"] == 2);
  CHECK(report["separatrices"]["ends"]["critical_point"] == 27);
  CHECK(report["separatrices"]["ends"]["boundary"] == 13);
  CHECK(report["separatrices"]["undecided"] == 0);
  CHECK(report["boundary_loops"].size() == 2);
  CHECK(report["certificate"]["certified"] == true);
  const auto verify = run_crest("crest-verify a.crest", folder.path());
  INFO(verify.out << verify.err);
  CHECK(verify.exit_code == 0);
}

TEST_CASE("crest-verify --input compares positions, triangles and vectors of a field") {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const char* last) {
    write_text(folder / name, two_triangles(kSquare, kCells, last));
  };
  write("a.vtk", "-1 -1 0");
  write("b.vtk", "-1 -1.5 0");
  const auto made = run_crest("crest skeleton a.vtk --certificate a.crest", folder.path());
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  const auto same = run_crest("crest-verify a.crest --input a.vtk --vectors v", folder.path());
  INFO(same.out << same.err);
  CHECK(same.exit_code == 0);
  CHECK(same.out.find("a.vtk holds the same positions, triangles and vectors") !=
        std::string::npos);
  const auto other = run_crest("crest-verify a.crest --input b.vtk", folder.path());
  CHECK(other.exit_code == 1);
  CHECK(other.out.find("REJECTED: b.vtk: other positions, triangles and vectors") !=
        std::string::npos);
  const auto none = run_crest("crest-verify a.crest --input c.vtk", folder.path());
  CHECK(none.exit_code == 3);
  const auto output = run_crest("crest-verify a.crest --input a.vtk --output b.vtk", folder.path());
  CHECK(output.exit_code == 2);
  CHECK(output.err.find("--output is for certificates of compression") != std::string::npos);
}

TEST_CASE("crest skeleton: winds and velocimetry") {
  const TemporaryFolder folder;
  const std::string header =
      "\"nx\":3,\"ny\":2,\"lo1\":0,\"lo2\":2,\"la1\":1,\"la2\":0,\"parameterNumber\":";
  write_text(folder / "w.json", "[{\"header\":{" + header +
                                    "2},\"data\":[1,1,1,1,1,1]},{\"header\":{" + header +
                                    "3},\"data\":[0.5,-1,0.5,0.25,-1,null]}]");
  auto run = run_crest("crest skeleton w.json --report w.rep.json", folder.path());
  INFO(run.err);
  CHECK(run.exit_code == 0);
  CHECK(read_json(folder / "w.rep.json")["triangles"] == 2);
  write_text(folder / "d.txt",
             "#DaVis 8\n0,5\t1\t1\t0\n1,5\t1\t1\t0\n0,5\t0\t1\t0,25\n1,5\t0\t1\t0,5\n");
  run = run_crest("crest skeleton d.txt --report d.json", folder.path());
  INFO(run.err);
  CHECK(run.exit_code == 0);
  CHECK(read_json(folder / "d.json")["vertices"] == 4);
}

TEST_CASE("crest skeleton: one line and exit code 3 for what it cannot take") {
  const TemporaryFolder folder;
  const SkeletonCase cases[] = {
      {"lifted.vtk", two_triangles("0 0 0  1 0 0  1 1 1  0 1 0", kCells, "0 -1 0"), "plane"},
      {"nan.vtk", two_triangles(kSquare, kCells, "nan 0 0"), "not finite"},
      {"flipped.vtk", two_triangles(kSquare, "3 0 1 2\n3 0 3 2", "0 -1 0"), "flipped"},
      {"thrice.vtk", two_triangles(kSquare, "3 0 1 2\n3 0 1 2", "0 -1 0"), "overlaps"},
      {"thin.vtk", two_triangles("0 0 0  1 0 0  1 1 0  2 2 0", kCells, "0 -1 0"), "no area"},
      {"empty.vtk", "", ""},
      {"cut.json", "[{\"header\":", "JSON"},
      {"words.txt", "x y u v\n1 2 3\n1 2 3 4\n", ""},
  };
  for (const SkeletonCase& c : cases) {
    INFO(c.name);
    write_text(folder / c.name, c.text);
    const auto run =
        run_crest(std::string("crest skeleton ") + c.name + " -o out.vtp", folder.path());
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(c.words) != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "out.vtp"));
  }
  write_text(folder / "good.vtk", two_triangles(kSquare, kCells, "0 -1 0"));
  CHECK(run_crest("crest skeleton good.vtk --vectors w", folder.path()).exit_code == 3);
  CHECK(run_crest("crest skeleton good.vtk --diagonal left", folder.path()).exit_code == 2);
}
