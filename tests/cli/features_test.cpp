// SPDX-License-Identifier: GPL-3.0-or-later
// crest features as a user runs it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/cli/run_crest.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest::tests;

TEST_CASE("crest features: outputs, report and an accepted certificate, the same bytes each time") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --vertices 1500 -o e.off", folder.path()).exit_code ==
          0);
  const std::string line =
      "crest features e.off --threshold 0.8 --close 1 --prune 3 --min-patch 4 --close-branches 4 ";
  const auto run = run_crest(line +
                                 "-o e.vtp --picture e.svg --report e.json --certificate e.crest "
                                 "--cite",
                             folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{roessl2005surfaces,") != std::string::npos);
  const auto report = read_json(folder / "e.json");
  for (const char* key :
       {"marked", "nodes", "arcs", "branches", "loops", "patches", "betti_before", "betti_after"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["betti_before"] == report["betti_after"]);
  CHECK(report["certificate"]["certified"] == true);
  CHECK(report["marked"].get<int>() > 280);
  const auto verdict = run_crest("crest-verify e.crest --input e.off", folder.path());
  INFO(verdict.out);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find(report["data_digest"].get<std::string>()) != std::string::npos);
  // The output is itself a mesh with lines on it.
  CHECK(run_crest("crest features e.vtp --quiet", folder.path()).exit_code == 0);
  REQUIRE(run_crest(line + "--threads 1 --quiet -o f.vtp --picture f.svg --certificate f.crest",
                    folder.path())
              .exit_code == 0);
  for (const char* extension : {".vtp", ".svg", ".crest"}) {
    CHECK(read_text(folder / (std::string("e") + extension)) ==
          read_text(folder / (std::string("f") + extension)));
  }
}

TEST_CASE("crest features refuses wrong options with exit code 2 and bad meshes with 3") {
  const TemporaryFolder folder;
  write_text(folder / "t.off",
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  write_text(folder / "bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 9\n");
  for (const char* options : {"--threshold 1.5",
                              "--threshold nan",
                              "--threshold 0.5 --value 1",
                              "--value x",
                              "--value nan",
                              "--dilate 1.5",
                              "--dilate -1",
                              "--dilate 1e999",
                              "--erode nan",
                              "--neighbourhood lattice",
                              "--method np",
                              "--method ne --rings 2",
                              "--rings 0",
                              "--absolute",
                              "--field k1 --method ne",
                              "--field k1 --rings 2",
                              "--prune -1",
                              "--prune 1.5",
                              "--min-patch x",
                              "--angle 181",
                              "--angle 6o",
                              "--angle -1",
                              "--angle 60 --threshold 0.5",
                              "--angle 60 --value 1",
                              "--angle 60 --method ne",
                              "--angle 60 --field k1",
                              "--angle 60 --close 1",
                              "--angle 60 --min-patch 3",
                              "--over 2",
                              "--angle 60 --over 0",
                              "--patches t.off",
                              "-o t.ply",
                              "--picture t.pdf"}) {
    const auto run = run_crest(std::string("crest features t.off ") + options, folder.path());
    INFO(options << "\n" << run.err);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.err.size() < 200);
  }
  for (const char* file : {"bad.off", "none.off"}) {
    const auto run =
        run_crest(std::string("crest features ") + file + " -o out.vtp", folder.path());
    CHECK(run.exit_code == 3);
    CHECK(is_one_line(run.err));
    CHECK_FALSE(fs::exists(folder / "out.vtp"));
  }
  for (const char* kind : {"path", "euclidean", "geodesic"}) {
    const std::string line = "crest features t.off --dilate 1.5 --cite --neighbourhood ";
    const auto run = run_crest(line + kind, folder.path());
    CHECK(run.exit_code == 0);
    CHECK((run.out.find("{kimmel1998computing,") != std::string::npos) ==
          (std::string(kind) == "geodesic"));
  }
}

TEST_CASE("crest features thresholds a point field, or the curvature of a chosen method") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --vertices 800 -o e.off", folder.path()).exit_code ==
          0);
  REQUIRE(run_crest("crest curvature e.off --method ne -o c.vtp", folder.path()).exit_code == 0);
  // On a convex surface |k2| is the larger one: the field and the method mark the same region.
  const auto field = run_crest(
      "crest features c.vtp --field k2 --absolute --prune 2 --quiet -o f.vtp --report f.json",
      folder.path());
  INFO(field.err);
  REQUIRE(field.exit_code == 0);
  REQUIRE(run_crest("crest features c.vtp --method ne --prune 2 --quiet -o m.vtp --report m.json",
                    folder.path())
              .exit_code == 0);
  CHECK(read_text(folder / "f.vtp") == read_text(folder / "m.vtp"));
  const auto f = read_json(folder / "f.json"), m = read_json(folder / "m.json");
  CHECK(f["field"] == "k2");
  CHECK_FALSE(f.contains("method"));
  CHECK(m["method"] == "ne");
  CHECK(f["thinnings"] == 1);
  CHECK(f["marked"] == f["thinned"]);
  for (const char* name : {"k3", "d1", ""}) {
    const auto run = run_crest(std::string("crest features c.vtp -o o.vtp --field '") + name + "'",
                               folder.path());
    INFO(name << "\n" << run.err);
    CHECK(run.exit_code == (*name ? 3 : 2));
    if (!*name) continue;
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("'k1', 'k2'") != std::string::npos);
    CHECK(run.err.find("c.vtp") == run.err.rfind("c.vtp"));
  }
  const auto off = run_crest("crest features e.off --field k1", folder.path());
  CHECK(off.exit_code == 3);
  CHECK(is_one_line(off.err));
  CHECK(off.err.find("field 'k1'") != std::string::npos);
}

TEST_CASE("crest features takes the values of vertices, and refuses those that are no numbers") {
  const TemporaryFolder folder;
  const auto vtp = [](const std::string& extra_point, const std::string& values) {
    const std::string array = "<DataArray type=\"Float64\" format=\"ascii\" ";
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
           "byte_order=\"LittleEndian\">\n<PolyData><Piece NumberOfPoints=\"" +
           std::string(extra_point.empty() ? "4" : "5") + "\" NumberOfPolys=\"4\">\n<PointData>" +
           array + "Name=\"a\">" + values + "</DataArray></PointData>\n<Points>" + array +
           "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0 0 1 " + extra_point +
           "</DataArray></Points>\n<Polys><DataArray type=\"Int64\" format=\"ascii\" "
           "Name=\"connectivity\">0 2 1 0 1 3 1 2 3 0 3 2</DataArray><DataArray type=\"Int64\" "
           "format=\"ascii\" Name=\"offsets\">3 6 9 12</DataArray></Polys>\n</Piece></PolyData>"
           "</VTKFile>\n";
  };
  write_text(folder / "good.vtp", vtp("", "1 2 3 4"));
  write_text(folder / "nan.vtp", vtp("", "1 2 nan 4"));
  write_text(folder / "loose.vtp", vtp("5 5 5", "1 2 3 4 -9"));
  for (const char* file : {"good.vtp", "loose.vtp"}) {
    const auto run = run_crest(
        std::string("crest features ") + file + " --field a --threshold 0.5 --report r.json",
        folder.path());
    INFO(file << "\n" << run.err);
    CHECK(run.exit_code == 0);
    CHECK(read_json(folder / "r.json")["threshold"] == 3);
  }
  const auto run = run_crest("crest features nan.vtp --field a -o o.vtp", folder.path());
  INFO(run.err);
  CHECK(run.exit_code == 3);
  CHECK(is_one_line(run.err));
  CHECK(run.err.find("nan.vtp") != std::string::npos);
  CHECK(run.err.find("nan.vtp") == run.err.rfind("nan.vtp"));
  CHECK_FALSE(fs::exists(folder / "o.vtp"));
}

namespace {

double total_length(const nlohmann::json& report) {
  double sum = 0;
  for (const auto& [kind, length] : report["length"].items()) sum += length.get<double>();
  return sum;
}

void check_cube(const nlohmann::json& report, double length) {
  CHECK(report["nodes"] == 8);
  CHECK(report["arcs"] == 12);
  CHECK(report["branches"] == 0);
  CHECK(report["loops"] == 0);
  CHECK(report["isolated"] == 0);
  CHECK(report["patches"] == 6);
  CHECK(total_length(report) == Approx(length).epsilon(1e-9));
}

/// The mesh turned about two axes and scaled.
std::string turned(const std::string& off, double turn, double scale) {
  const auto lines = split_lines(off);
  const std::size_t vertices = std::stoul(lines.at(1));
  const double c = std::cos(turn), s = std::sin(turn);
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::istringstream words(lines[i]);
    double x = 0, y = 0, z = 0;
    if (i >= 2 && i < 2 + vertices && words >> x >> y >> z) {
      const double u = c * x - s * y, v = s * x + c * y;
      text << scale * u << ' ' << scale * (c * v - s * z) << ' ' << scale * (s * v + c * z);
    } else {
      text << lines[i];
    }
    text << '\n';
  }
  return text.str();
}

}  // namespace

TEST_CASE("crest features: fields in which nothing stands out are named") {
  const TemporaryFolder folder;
  write_text(folder / "cube.off",
             "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
             "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  write_text(folder / "flat.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
             "property double z\nproperty int q\nelement face 4\nproperty list uchar int "
             "vertex_indices\nend_header\n0 0 0 7\n1 0 0 7\n0 1 0 7\n0 0 1 7\n"
             "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto said = [&](const char* line, const char* words) {
    const auto result = run_crest(line, folder.path());
    INFO(line << ": " << result.err);
    CHECK(result.exit_code == 0);
    CHECK(result.err.find(words) != std::string::npos);
  };
  said("crest features cube.off", "the curvatures are zero but for rounding");
  said("crest features flat.ply --field q", "the field has one value");
  CHECK(run_crest("crest features cube.off --angle 60", folder.path()).err.find("zero") ==
        std::string::npos);
}

TEST_CASE("crest features: a cube's lines are its edges, by default, by ne and by angle") {
  const auto file = shared_data("reported/geo_cube_8.off");
  if (!file) return;
  const TemporaryFolder folder;
  const std::string cube = read_text(*file);
  for (const auto& [turn, scale] :
       std::vector<std::pair<double, double>>{{0, 1}, {0.7, 1}, {1.9, 1e-3}, {2.6, 777}}) {
    write_text(folder / "c.off", turn == 0 ? cube : turned(cube, turn, scale));
    for (const char* options :
         {"", "--method ne", "--angle 60", "--angle 30", "--angle 89.99999"}) {
      INFO(options << ", turned by " << turn << ", scale " << scale);
      const auto run = run_crest(std::string("crest features c.off --report r.json "
                                             "--certificate c.crest ") +
                                     options,
                                 folder.path());
      INFO(run.err);
      REQUIRE(run.exit_code == 0);
      check_cube(read_json(folder / "r.json"), 24 * scale);
      CHECK(run_crest("crest-verify c.crest --input c.off", folder.path()).exit_code == 0);
    }
  }
  write_text(folder / "c.off", cube);
  const auto right = run_crest("crest features c.off --angle 90 --report r.json", folder.path());
  CHECK(right.err.find("edges of exactly 90 degrees (96)") != std::string::npos);
  const auto report = read_json(folder / "r.json");
  CHECK(report["sharp_edges"] == 0);
  CHECK(report["sharp_ties"] == 96);
  CHECK(report["patches"] == 1);
  CHECK(report["predicates"]["dihedral_angle"]["calls"] == 1152);
}

TEST_CASE(
    "crest features --angle: fandisk's 699 edges above 60 degrees, its patches, a certificate") {
  const auto file = shared_data("meshes/fandisk.off");
  if (!file) return;
  const TemporaryFolder folder;
  const auto run = run_crest("crest features '" + *file +
                                 "' --angle 60 -o f.vtp --patches p.ply --report r.json "
                                 "--certificate f.crest --cite",
                             folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{niven1956irrational,") != std::string::npos);
  const auto report = read_json(folder / "r.json");
  CHECK(report["sharp_edges"] == 699);
  CHECK(report["line_edges"] == 699);
  CHECK(report["arcs"] == 32);
  CHECK(report["branches"] == 2);
  CHECK(report["nodes"] == 22);
  CHECK(report["patches"] == 12);
  CHECK(report["certificate"]["claims"] == nlohmann::json::array({"sharp-edges"}));
  const auto verdict = run_crest("crest-verify f.crest --input '" + *file + "'", folder.path());
  INFO(verdict.out);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find("699 of 19419 edges, and no others, are above 60 degrees") !=
        std::string::npos);
  CHECK(verdict.out.find(report["data_digest"].get<std::string>()) != std::string::npos);
  // A patch number a face, from 0, in the order of the first faces.
  const auto lines = split_lines(read_text(folder / "p.ply"));
  CHECK(std::count(lines.begin(), lines.end(), "property int patch") == 1);
  int most = -1;
  for (std::size_t i = lines.size() - 12946; i < lines.size(); ++i) {
    const int patch = std::stoi(lines[i].substr(lines[i].rfind(' ') + 1));
    CHECK(patch <= most + 1);
    most = std::max(most, patch);
  }
  CHECK(most == 11);
  // The mesh with patches is a mesh; joining takes both dangling ends on, or none.
  CHECK(run_crest("crest features p.ply --angle 60 --report q.json", folder.path()).exit_code == 0);
  CHECK(read_json(folder / "q.json")["sharp_edges"] == 699);
  REQUIRE(run_crest("crest features p.ply --angle 60 --prune 1000 --report q.json", folder.path())
              .exit_code == 0);
  CHECK(read_json(folder / "q.json")["branches"] == 0);
  CHECK(read_json(folder / "q.json")["sharp_edges"] == 699);
  CHECK(read_json(folder / "q.json")["dropped_lines"] == 2);
}

TEST_CASE("crest features says which options left out what the certificate holds") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --noise 0.05 --seed 7 --vertices 1500 -o n.off",
                    folder.path())
              .exit_code == 0);
  const auto check = [&](const std::string& options, const std::string& words,
                         const std::vector<std::string>& by) {
    const auto run = run_crest("crest features n.off " + options +
                                   " --report r.json --picture r.svg --certificate r.crest",
                               folder.path());
    INFO(options << "\n" << run.out << run.err);
    REQUIRE(run.exit_code == 0);
    CHECK((run.out.find(words) != std::string::npos) != by.empty());
    const auto certificate = read_json(folder / "r.json")["certificate"];
    CHECK(certificate["subset"] == !by.empty());
    CHECK(certificate["subset_by"] == nlohmann::json(by));
    for (const std::string& option : by)
      CHECK(read_text(folder / "r.svg").find(option) != std::string::npos);
    return certificate["counts"];
  };
  const auto all = check("--angle 20", "written: ", {});
  CHECK(check("--angle 20 --prune 3",
              "written: a subset of the certified sharp edges: ", {"--prune"}) == all);
  CHECK(all["sharp_edges"].get<int>() > 0);
  const auto joined =
      check("--angle 20 --close-branches 6",
            "written: a simplification of the certified sharp edges: ", {"--close-branches"});
  CHECK(joined == all);
  check("--threshold 0.8", "written: ", {});
  const auto thinned = check("--threshold 0.8 --prune 6",
                             "written: a subset of the certified thinned region: ", {"--prune"});
  CHECK(thinned["dropped"].get<int>() > 0);
  check("--threshold 0.8 --min-patch 100",
        "written: a simplification of the marked region: ", {"--min-patch"});
}
