// SPDX-License-Identifier: GPL-3.0-or-later
// crest reeb as a user runs it.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "tests/cli/run_crest.hpp"
#include "tests/support/quadratic_files.hpp"
#include "tests/support/random.hpp"

using namespace crest::tests;

namespace {

double slanted(const Vec3& p) {
  return p[0] + 0.1 * p[1] + 0.01 * p[2] * p[2];
}

/// Keeps what it says about the result: not times and memory.
nlohmann::json result_of(const fs::path& path) {
  nlohmann::json json = read_json(path);
  for (const char* key : {"seconds", "peak_rss_bytes", "threads", "input", "predicates"})
    json.erase(key);
  return json;
}

}  // namespace

TEST_CASE("crest reeb: outputs, report and an accepted certificate, the same bytes each time") {
  const TemporaryFolder folder;
  write_text(folder / "t.vtu", vtu_text(torus_grid(20, 14, slanted)));
  const std::string line = "crest reeb t.vtu --level 0.5 --segmentation ";
  const auto run = run_crest(line +
                                 "-o a.vtp --picture a.svg --report a.json --certificate a.crest "
                                 "--cite",
                             folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{dillard2006tessellation,") != std::string::npos);
  const auto report = read_json(folder / "a.json");
  for (const char* key : {"crest",          "command",
                          "input",          "seconds",
                          "peak_rss_bytes", "threads",
                          "predicates",     "certificate",
                          "warnings",       "function",
                          "degree",         "vertices",
                          "faces",          "euler_characteristic",
                          "boundary_loops", "line_critical",
                          "face_critical",  "tiles",
                          "ties",           "critical_points",
                          "tied_arcs",      "certificate_is_of",
                          "graph",          "written",
                          "levels",         "data_digest"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  for (const char* key : {"minima", "saddles", "maxima"})
    CHECK(report["critical_points"].contains(key));
  for (const char* key : {"nodes", "arcs", "loops", "components"})
    CHECK(report["graph"].contains(key));
  for (const char* rule :
       {"line_critical", "face_critical", "boundary_saddle", "critical_value_order"}) {
    INFO(rule);
    REQUIRE(report["predicates"].contains(rule));
    for (const char* key : {"calls", "interval", "integer", "exact", "symbolic"})
      CHECK(report["predicates"][rule].contains(key));
  }
  CHECK(report["predicates"]["line_critical"]["calls"] > 0);
  for (const char* phase :
       {"read", "tessellate", "graph", "certificate", "places", "write", "total"})
    CHECK(report["seconds"].contains(phase));
  CHECK_FALSE(report["seconds"].contains("simplify"));
  CHECK(report["function"] == "T");
  CHECK(report["euler_characteristic"] == 0);
  CHECK(report["boundary_loops"] == 0);
  CHECK(report["graph"]["loops"] == 1);
  CHECK(report["graph"]["components"] == 1);
  CHECK(report["critical_points"]["index_sum"] == 0);
  CHECK(report["levels"][0]["cycles"] == 2);
  CHECK(report["levels"][0]["paths"] == 0);
  CHECK(report["certificate"]["certified"] == true);
  const auto verdict = run_crest("crest-verify a.crest", folder.path());
  INFO(verdict.out);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find(report["data_digest"].get<std::string>()) != std::string::npos);
  REQUIRE(run_crest(line + "--threads 1 --quiet -o b.vtp --picture b.svg --certificate b.crest",
                    folder.path())
              .exit_code == 0);
  for (const char* extension : {".vtp", ".svg", ".crest"}) {
    CHECK(read_text(folder / (std::string("a") + extension)) ==
          read_text(folder / (std::string("b") + extension)));
  }
}

TEST_CASE("crest reeb gives the same graph for any numbering of the triangles") {
  const TemporaryFolder folder;
  for (const bool ties : {false, true}) {
    QuadraticGrid grid = torus_grid(9, 7, [&](const Vec3& p) {
      return ties ? std::round(2 * slanted(p)) : std::sin(5 * p[0] + p[2]) * p[1];
    });
    write_text(folder / "a.vtu", vtu_text(grid));
    Random random(kSeed);
    std::shuffle(grid.cells.begin(), grid.cells.end(), random);
    write_text(folder / "b.vtu", vtu_text(grid));
    // Faces also turned and mirrored: another corner first, the other way round.
    for (auto& c : grid.cells) {
      if (random() & 1) c = {c[1], c[2], c[0], c[4], c[5], c[3]};
      if (random() & 1) c = {c[0], c[2], c[1], c[5], c[4], c[3]};
    }
    write_text(folder / "c.vtu", vtu_text(grid));
    for (const std::string name : {"a", "b", "c"}) {
      const auto run = run_crest("crest reeb " + name + ".vtu --quiet --level 0.25 -o " + name +
                                     ".vtp --report " + name + ".json",
                                 folder.path());
      INFO(run.err);
      REQUIRE(run.exit_code == 0);
    }
    CHECK(result_of(folder / "a.json") == result_of(folder / "b.json"));
    CHECK(result_of(folder / "a.json") == result_of(folder / "c.json"));
    CHECK(read_text(folder / "a.vtp") == read_text(folder / "b.vtp"));
  }
}

TEST_CASE("crest reeb --contract gives the same graph for any numbering of the vertices") {
  const TemporaryFolder folder;
  const QuadraticGrid grids[] = {
      torus_grid(7, 6, [](const Vec3& p) { return std::round(2 * slanted(p)); }),
      square_grid(5, [](const Vec3& p) { return std::round(3 * p[0] * p[1]); }),
      moebius_grid(9, [](const Vec3& p) { return std::round(2 * p[0]); })};
  for (const QuadraticGrid& grid : grids) {
    QuadraticGrid other = grid;
    std::vector<Index> number(grid.nodes.size());
    std::iota(number.begin(), number.end(), 0u);
    Random random(kSeed);
    std::shuffle(number.begin(), number.end(), random);
    for (Index v = 0; v < number.size(); ++v) {
      other.nodes[number[v]] = grid.nodes[v];
      other.values[number[v]] = grid.values[v];
    }
    for (auto& cell : other.cells)
      for (Index& v : cell) v = number[v];
    write_text(folder / "a.vtu", vtu_text(grid));
    write_text(folder / "b.vtu", vtu_text(other));
    for (const std::string name : {"a", "b"}) {
      const auto run = run_crest("crest reeb " + name + ".vtu --quiet --contract -o " + name +
                                     ".vtp --report " + name + ".json",
                                 folder.path());
      INFO(run.err);
      REQUIRE(run.exit_code == 0);
    }
    const auto a = read_json(folder / "a.json"), b = read_json(folder / "b.json");
    CHECK(a["ties"].get<int>() > 0);
    CHECK(a["written"] == b["written"]);
  }
}

TEST_CASE("crest reeb simplifies, and grows merge and contour trees") {
  const TemporaryFolder folder;
  const auto bumpy = [](const Vec3& p) { return std::sin(7 * p[0]) * std::cos(6 * p[1]) + p[2]; };
  write_text(folder / "torus.vtu", vtu_text(torus_grid(30, 20, bumpy)));
  write_text(folder / "disk.vtu", vtu_text(square_grid(20, bumpy)));
  write_text(folder / "flat.vtu", vtu_text(torus_grid(5, 4, [](const Vec3&) { return 1.0; })));
  const auto report = [&](const std::string& arguments) {
    const auto run =
        run_crest("crest reeb --quiet --report r.json -o r.vtp " + arguments, folder.path());
    INFO(arguments << run.err);
    REQUIRE(run.exit_code == 0);
    return read_json(folder / "r.json");
  };
  const auto all = report("torus.vtu --join-tree --split-tree --segmentation");
  CHECK(all["graph"]["nodes"].get<int>() > 20);
  CHECK(all["graph"] == all["written"]);
  CHECK(all["certificate"]["subset"] == false);
  // A leaf a minimum (maximum), and the root.
  CHECK(all["join_tree"]["leaves"] == all["critical_points"]["minima"].get<int>() + 1);
  CHECK(all["split_tree"]["leaves"] == all["critical_points"]["maxima"].get<int>() + 1);
  const auto some = report("torus.vtu --persistence 0.5 --segmentation");
  CHECK(some["written"]["nodes"] < all["graph"]["nodes"]);
  CHECK(some["written"]["loops"] == 1);
  CHECK(some["graph"] == all["graph"]);
  CHECK(some["certificate"]["subset"] == true);
  CHECK(some["certificate"]["counts"] == all["graph"]);
  CHECK(some["certificate"]["subset_by"] == nlohmann::json::array({"--persistence"}));
  const auto least = report("torus.vtu --persistence 1e9 --cancel-loops");
  CHECK(least["written"]["nodes"] == 2);
  CHECK(least["written"]["arcs"] == 1);
  CHECK(least["certificate"]["subset_by"] ==
        nlohmann::json::array({"--persistence", "--cancel-loops"}));
  const auto disk = report("disk.vtu --contour-tree --level 0 --level 0.5");
  CHECK(disk["graph"]["loops"] == 0);
  CHECK(disk["contour_tree"]["arcs"] == disk["graph"]["arcs"]);
  CHECK(disk["levels"].size() == 2);
  CHECK(disk["boundary_loops"] == 1);
  const auto flat = report("flat.vtu --contract --segmentation --picture r.svg");
  CHECK(flat["written"]["nodes"] == 1);
  CHECK(flat["written"]["arcs"] == 0);
  CHECK(read_text(folder / "r.svg").find("simplified by --contract") != std::string::npos);
  const auto refused = run_crest("crest reeb torus.vtu --contour-tree -o no.vtp", folder.path());
  CHECK(refused.exit_code == 3);
  CHECK(is_one_line(refused.err));
  CHECK(refused.err.find("torus.vtu: surface: is not simply connected") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "no.vtp"));
}

TEST_CASE("crest reeb reads Gmsh files and one-sided surfaces, and takes expressions") {
  const TemporaryFolder folder;
  const QuadraticGrid torus = torus_grid(9, 7, slanted), strip = moebius_grid(12, slanted);
  write_text(folder / "t.vtu", vtu_text(torus));
  write_text(folder / "t2.msh", msh_text(torus, 2));
  write_text(folder / "t4.msh", msh_text(torus, 4));
  write_text(folder / "m.vtu", vtu_text(strip));
  for (const char* name : {"t.vtu", "t2.msh", "t4.msh"}) {
    INFO(name);
    const auto run = run_crest(std::string("crest reeb ") + name + " --quiet --report " + name +
                                   ".json --certificate " + name + ".crest",
                               folder.path());
    REQUIRE(run.exit_code == 0);
  }
  CHECK(read_text(folder / "t.vtu.crest") == read_text(folder / "t2.msh.crest"));
  CHECK(read_text(folder / "t.vtu.crest") == read_text(folder / "t4.msh.crest"));
  const auto strip_run = run_crest(
      "crest reeb m.vtu --quiet --report m.json --certificate m.crest && "
      "crest-verify m.crest",
      folder.path());
  INFO(strip_run.out << strip_run.err);
  CHECK(strip_run.exit_code == 0);
  CHECK(read_json(folder / "m.json")["boundary_loops"] == 1);

  REQUIRE(
      run_crest("crest sample torus --vertices 900 --quiet -o s.off", folder.path()).exit_code ==
      0);
  const auto counts = [&](const std::string& options) {
    const auto run =
        run_crest("crest reeb s.off --quiet --report s.json " + options, folder.path());
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    return read_json(folder / "s.json");
  };
  const auto quadratic = counts("--expression 'x + y*y/8'");
  CHECK(quadratic["degree"] == 2);
  CHECK(quadratic["graph"]["loops"] == 1);
  CHECK(counts("--expression 'x + y/8'")["degree"] == 1);
  const auto linear = counts("--expression 'x + y*y/8' --linear");
  CHECK(linear["degree"] == 1);
  CHECK(linear["tiles"] == linear["faces"]);
  CHECK(linear["graph"]["loops"] == 1);
  // A constant: every tie decided by number, one minimum and one maximum.
  const auto constant = counts("--expression '0*x'");
  CHECK(constant["ties"].get<int>() == constant["vertices"].get<int>() - 1);
  CHECK(constant["critical_points"]["index_sum"] == 0);
  CHECK(constant["tied_arcs"] == constant["graph"]["arcs"]);
  CHECK(quadratic["tied_arcs"] == 0);
}

TEST_CASE("crest reeb says how many values are tied and which graph is certified") {
  const TemporaryFolder folder;
  REQUIRE(
      run_crest("crest sample sphere --vertices 300 --quiet -o s.off", folder.path()).exit_code ==
      0);
  const auto run = [&](const std::string& options) {
    const auto done = run_crest("crest reeb s.off " + options, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    return done.out;
  };
  const std::string constant =
      run("--expression '0*x' --contract --certificate c.crest --report c.json");
  const auto report = read_json(folder / "c.json");
  CHECK(report["certificate_is_of"] == "graph");
  CHECK(report["written"]["nodes"] == 1);
  CHECK(constant.find("ties: " + std::to_string(report["ties"].get<int>()) + " values equal") !=
        std::string::npos);
  CHECK(constant.find("--contract gives the graph of the function itself") != std::string::npos);
  CHECK(constant.find("written: a simplification of the certified Reeb graph: 1 nodes, 0 arcs, 0 "
                      "loops, 1 components (--contract)\n") != std::string::npos);
  const auto verdict = run_crest("crest-verify c.crest", folder.path());
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find("contracted: 1 nodes, 0 arcs") != std::string::npos);
  const std::string generic = run("--expression 'x + y/8 + z/64' --linear --report g.json");
  CHECK(generic.find("ties: ") == std::string::npos);
  CHECK(generic.find("certified") == std::string::npos);
  CHECK(read_json(folder / "g.json")["certificate_is_of"].is_null());
}

TEST_CASE("crest reeb refuses wrong options with exit code 2 and bad input with 3") {
  const TemporaryFolder folder;
  write_text(folder / "t.off",
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  QuadraticGrid grid = square_grid(1, slanted);
  write_text(folder / "s.vtu", vtu_text(grid));
  grid.values[5] = std::nan("");
  write_text(folder / "nan.vtu", vtu_text(grid));
  grid.values[5] = 0;
  grid.cells.push_back({0, 3, 5, 6, 6, 6});
  write_text(folder / "edge.vtu", vtu_text(grid));
  grid.cells.clear();
  write_text(folder / "empty.vtu", vtu_text(grid));
  write_text(folder / "zero.vtu", "");
  for (const char* options :
       {"", "--expression 'x +'", "--expression 'w'", "--expression x --field T", "--level",
        "--expression x --persistence -1", "--expression x --cancel-loops",
        "--expression x --level nan", "--expression x --level 1x", "--expression x -o t.ply",
        "--expression x --picture t.pdf"}) {
    const auto run = run_crest(std::string("crest reeb t.off ") + options, folder.path());
    INFO(options << "\n" << run.err);
    CHECK(run.exit_code == (*options == '\0' ? 3 : 2));
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
  }
  const auto column = run_crest("crest reeb t.off --expression 'x * * y'", folder.path());
  CHECK(column.err.find("--expression: column 5: ") != std::string::npos);
  for (const char* file :
       {"nan.vtu", "edge.vtu", "empty.vtu", "zero.vtu", "none.vtu", "s.vtu --field U"}) {
    const auto run = run_crest(std::string("crest reeb ") + file + " -o out.vtp", folder.path());
    INFO(file << "\n" << run.err);
    CHECK(run.exit_code == 3);
    CHECK(is_one_line(run.err));
    CHECK_FALSE(fs::exists(folder / "out.vtp"));
  }
}
