// SPDX-License-Identifier: GPL-3.0-or-later
// crest modes as a user runs it, on the stress of a block of 360 tetrahedra and on files by hand.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

constexpr const char* kSample = "crest sample block-twist --vertices 120 -o s.vtu --quiet";

/// Two tetrahedra with a tensor at each point, as legacy VTK; `last` stands at the last point.
std::string two_tets(const std::string& last) {
  return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n"
         "0 0 0  1 0 0  0 1 0  0 0 1  1 1 1\nCELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\n"
         "CELL_TYPES 2\n10 10\nPOINT_DATA 5\nTENSORS t double\n"
         "2 0 0  0 -1 0  0 0 -1\n1 1 0  1 -2 0  0 0 1\n0 0 1  0 1 0  1 0 -1\n"
         "-1 0 2  0 2 1  2 1 -1\n" +
         last + "\n";
}

struct ModesCase {
  const char* arguments;
  int exit_code;
  const char* words;
};

}  // namespace

TEST_CASE("crest modes: surfaces, report, picture and an accepted certificate") {
  const TemporaryFolder folder;
  REQUIRE(run_crest(kSample, folder.path()).exit_code == 0);
  for (const std::string end : {"vtp", "ply", "obj"}) {
    const auto run = run_crest("crest modes s.vtu --mode 0.5 --neutral -o a." + end +
                                   " --picture a.svg --report a.json --certificate a.crest "
                                   "--cite",
                               folder.path());
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.find("{qu2020mode,") != std::string::npos);
    CHECK(fs::file_size(folder / ("a." + end)) > 0);
  }
  const auto report = read_json(folder / "a.json");
  for (const char* key : {"crest", "command", "input", "seconds", "peak_rss_bytes", "threads",
                          "certificate", "warnings", "surfaces", "tets", "field", "tensor"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["certificate"]["certified"] == true);
  REQUIRE(report["surfaces"].size() == 3);
  const auto verify = run_crest("crest-verify a.crest", folder.path());
  INFO(verify.out << verify.err);
  CHECK(verify.exit_code == 0);
  // The checker states the counts of the report.
  for (const auto& surface : report["surfaces"]) {
    CHECK(surface["watertight"] == true);
    CHECK(surface["max_mode_error"] < 1e-12);
    std::size_t loops = 0;
    for (const auto& c : surface["components"]) {
      loops += c["boundary_loops"].get<std::size_t>();
      CHECK(c["orientable"] == true);
    }
    const std::string counts = std::to_string(surface["components"].size()) +
                               " components, Euler characteristic " +
                               std::to_string(surface["euler_characteristic"].get<int>()) + ", " +
                               std::to_string(loops) + " boundary loops";
    INFO(counts << "\n" << verify.out);
    CHECK(verify.out.find(counts) != std::string::npos);
  }
}

TEST_CASE("crest modes: the same bytes each time, for any number of threads") {
  const TemporaryFolder folder;
  REQUIRE(run_crest(kSample, folder.path()).exit_code == 0);
  for (const std::string threads : {"1", "2", "3"})
    CHECK(run_crest("crest modes s.vtu --mode 0.5 --neutral -o " + threads + ".vtp --certificate " +
                        threads + ".crest --threads " + threads,
                    folder.path())
              .exit_code == 0);
  for (const std::string end : {".vtp", ".crest"})
    for (const std::string threads : {"2", "3"})
      CHECK(read_text(folder / (threads + end)) == read_text(folder / ("1" + end)));
}

TEST_CASE("crest modes --degenerate: curves, their report, picture and certificate") {
  const TemporaryFolder folder;
  REQUIRE(run_crest(kSample, folder.path()).exit_code == 0);
  const auto run = run_crest(
      "crest modes s.vtu --degenerate -o c.vtp --picture c.png --report c.json --certificate "
      "c.crest",
      folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const auto curves = read_json(folder / "c.json")["degenerate_curves"];
  for (const char* type : {"linear", "planar"})
    for (const char* key : {"count", "closed", "length", "face_points"})
      CHECK(curves[type].contains(key));
  CHECK(curves["linear"]["count"].get<int>() + curves["planar"]["count"].get<int>() > 0);
  CHECK(curves["undecided"].empty());
  const auto verify = run_crest("crest-verify c.crest --input s.vtu", folder.path());
  INFO(verify.out << verify.err);
  CHECK(verify.exit_code == 0);
}

TEST_CASE("crest modes: one line and the right exit code for what cannot be done") {
  const TemporaryFolder folder;
  const std::string traceless = "1 0 0  0 1 0  0 0 -2";
  write_text(folder / "t.vtk", two_tets(traceless));
  write_text(folder / "nan.vtk", two_tets("nan 0 0  0 1 0  0 0 -2"));
  write_text(folder / "skew.vtk", two_tets("1 0.5 0  0 1 0  0 0 -2"));
  write_text(folder / "large.vtk", two_tets("1e302 0 0  0 1e302 0  0 0 -2e302"));
  write_text(folder / "mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (const ModesCase& c :
       {ModesCase{"t.vtk --mode 1", 2, "--degenerate"},
        ModesCase{"t.vtk --mode 1.5", 2, "between -1 and 1"},
        ModesCase{"t.vtk --mode 1/0", 2, "denominator 0"},
        ModesCase{"t.vtk --mode half", 2, "neither a decimal nor a fraction"},
        ModesCase{"t.vtk", 2, "give --mode MU, --neutral or --degenerate"},
        ModesCase{"t.vtk --neutral --tensor stress", 3, "stress"},
        ModesCase{"nan.vtk --neutral", 3, "4"}, ModesCase{"mesh.off --neutral", 3, "mesh.off"},
        ModesCase{"none.vtu --neutral", 3, "does not exist"},
        ModesCase{"large.vtk --mode 0.5 --certificate c.crest", 3, "large.vtk: tensors: entries"},
        ModesCase{"t.vtk --neutral -o t.png", 2, "t.png"}}) {
    const auto run = run_crest(std::string("crest modes ") + c.arguments, folder.path());
    INFO(c.arguments << "\n" << run.err);
    CHECK(run.exit_code == c.exit_code);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(c.words) != std::string::npos);
  }
  const auto skew = run_crest("crest modes skew.vtk --neutral", folder.path());
  CHECK(skew.exit_code == 0);
  CHECK(skew.err.find("its symmetric part is taken") != std::string::npos);
}
