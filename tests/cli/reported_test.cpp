// SPDX-License-Identifier: GPL-3.0-or-later
// Files that users of comparable programs reported (../shared/data/reported/README.md): what was
// cleaned, the right values, and crest-verify --input takes the same file.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest::tests;
using nlohmann::json;

namespace {

std::optional<std::string> reported(const std::string& name) {
  return shared_data("reported/" + name);
}

/// The report of a command that must be done, with the warnings and cleanups it must have.
json report_of(const TemporaryFolder& folder, const std::string& command) {
  const auto run = run_crest("crest " + command + " --quiet --report r.json", folder.path());
  INFO(command << "\n" << run.err);
  REQUIRE(run.exit_code == 0);
  return read_json(folder / "r.json");
}

struct Counts {
  int vertices, faces, euler, umbilics;
  double index_sum;
  std::array<int, 2> loops_and_segments;  ///< of either colour
};
constexpr Counts kEllipsoid = {642, 1280, 2, 4, 2, {1, 2}};

struct ReportedCase {
  const char* file;
  const char* options;
  const char* count;  ///< of cleanup
  int value;
  Counts expected;
};

const ReportedCase kCases[] = {
    {"top_duplicate_faces.off", "", "duplicate_faces", 10, kEllipsoid},
    {"top_repeated_index.off", "", "repeated_corners", 2, kEllipsoid},
    {"off_nan_unreferenced.off", "", "unused_vertices", 5, kEllipsoid},
    {"top_inside_out.off", "", "inside_out_components", 1, {642, 1280, 2, 4, 2, {1, 2}}},
    {"top_inside_out.off", "--outward", "turned_components", 1, kEllipsoid},
    {"ply_soup_of_triangles.ply", "--weld 0", "welded_vertices", 3198, kEllipsoid},
    {"top_bow_tie_vertex.off", "", "split_vertices", 1, {1284, 2560, 4, 8, 4, {2, 4}}},
};

std::string warnings_of(const json& report) {
  return report["warnings"].dump();
}

}  // namespace

TEST_CASE("ridges of reported files have the right counts, and their certificates the same file") {
  const TemporaryFolder folder;
  for (const ReportedCase& c : kCases) {
    const auto file = reported(c.file);
    if (!file) return;
    INFO(c.file << " " << c.options);
    const json report =
        report_of(folder, fmt::format("ridges '{}' {} --certificate c.crest", *file, c.options));
    CHECK(report["cleanup"][c.count] == c.value);
    CHECK(report["warnings"].size() == (c.value == 1 && c.expected.euler == 4 ? 2 : 1));
    CHECK(warnings_of(report).find(std::to_string(c.value) + " ") != std::string::npos);
    CHECK(report["vertices"] == c.expected.vertices);
    CHECK(report["faces"] == c.expected.faces);
    CHECK(report["euler_characteristic"] == c.expected.euler);
    CHECK(report["boundary_loops"] == 0);
    CHECK(report["umbilics"]["count"] == c.expected.umbilics);
    CHECK(report["umbilics"]["index_sum"] == c.expected.index_sum);
    for (const char* colour : {"blue", "red"}) {
      CHECK(report["ridges"][colour]["loops"] == c.expected.loops_and_segments[0]);
      CHECK(report["ridges"][colour]["segments"] == c.expected.loops_and_segments[1]);
    }
    const auto verdict = run_crest(
        fmt::format("crest-verify c.crest --input '{}' {}", *file, c.options), folder.path());
    INFO(verdict.out << verdict.err);
    CHECK(verdict.exit_code == 0);
    CHECK(verdict.out.find("the same positions and faces, oriented as in") != std::string::npos);
  }
}

TEST_CASE("an edge of zero length is collapsed for geometry, kept for a function") {
  const TemporaryFolder folder;
  const auto file = reported("geo_zero_edge.off");
  if (!file) return;
  for (const std::string command : {"ridges", "curvature", "features"}) {
    const json report = report_of(folder, command + " '" + *file + "'");
    CHECK(report["vertices"] == 641);
    CHECK(report["faces"] == 1278);
    CHECK(report["cleanup"]["collapsed_edges"] == 1);
    CHECK(warnings_of(report).find("collapsed 1 edge of length zero") != std::string::npos);
  }
  CHECK(report_of(folder, "reeb '" + *file + "' --expression z")["vertices"] == 642);
  REQUIRE(
      run_crest("crest features '" + *file + "' --certificate c.crest", folder.path()).exit_code ==
      0);
  CHECK(run_crest("crest-verify c.crest --input '" + *file + "'", folder.path()).exit_code == 0);
}

TEST_CASE("polygons of every format give the torus and the cube") {
  const TemporaryFolder folder;
  for (const char* name : {"obj_quad_torus.obj", "vtp_quads.vtp", "vtu_mixed.vtu"}) {
    const auto file = reported(name);
    if (!file) return;
    INFO(name);
    const json report = report_of(folder, "reeb '" + *file + "' --expression y");
    CHECK(report["vertices"] == 800);
    CHECK(report["faces"] == 1600);
    CHECK(report["euler_characteristic"] == 0);
    CHECK(report["graph"]["nodes"] == 4);
    CHECK(report["graph"]["loops"] == 1);
    const json ridges = report_of(folder, "ridges '" + *file + "' --certificate c.crest");
    CHECK(ridges["euler_characteristic"] == 0);
    CHECK(ridges["cleanup"]["polygons"] == report["cleanup"]["polygons"]);
    for (const json& umbilic : ridges["umbilics"]["items"]) CHECK(umbilic["face"] < 1600);
    CHECK(run_crest("crest-verify c.crest --input '" + *file + "'", folder.path()).exit_code == 0);
  }
  const json cube = report_of(folder, "curvature '" + *reported("off_quad_cube.off") + "'");
  CHECK(cube["vertices"] == 8);
  CHECK(cube["faces"] == 12);
  const json facets = report_of(folder, "features '" + *reported("stl_zero_facets.stl") + "'");
  CHECK(facets["vertices"] == 98);
  CHECK(facets["faces"] == 192);
  CHECK(facets["euler_characteristic"] == 2);
  CHECK(facets["cleanup"]["repeated_corners"] == 2);
}

TEST_CASE("texture seams are named with the option that closes them") {
  const TemporaryFolder folder;
  const auto file = reported("obj_uv_seams_doubled.obj");
  if (!file) return;
  for (const std::string command : {"ridges", "reeb --expression y"}) {
    const json open = report_of(folder, command + " '" + *file + "'");
    CHECK(open["cleanup"]["coincident_vertices"] == 61);
    CHECK(warnings_of(open).find("61 vertices stand at the place of another one") !=
          std::string::npos);
    CHECK(warnings_of(open).find("--weld 0") != std::string::npos);
    const json closed = report_of(folder, command + " '" + *file + "' --weld 0");
    CHECK(closed["vertices"] == 800);
    CHECK(closed["euler_characteristic"] == 0);
    CHECK(closed["boundary_loops"] == 0);
    CHECK(closed["cleanup"]["coincident_vertices"] == 0);
  }
  CHECK(report_of(folder, "reeb '" + *file + "' --expression y --weld 0")["graph"]["loops"] == 1);
  const json soup = report_of(
      folder, "reeb '" + *reported("ply_soup_of_triangles.ply") + "' --expression z --weld 0");
  CHECK(soup["graph"]["nodes"] == 2);
}

TEST_CASE("fields: ties are said, what is not exact or finite is refused alike by all commands") {
  const TemporaryFolder folder;
  const auto file = reported("vtp_fields.vtp");
  if (!file) return;
  const std::pair<const char*, int> contracted[] = {{"constant", 1}, {"label", 2}, {"u8", 2}};
  for (const auto& [field, nodes] : contracted) {
    const std::string command = fmt::format("reeb '{}' --field {}", *file, field);
    const json report = report_of(folder, command);
    CHECK(report["ties"] > 0);
    CHECK(report["tied_arcs"] > 0);
    CHECK(warnings_of(report).find("--contract gives the graph of the function itself") !=
          std::string::npos);
    CHECK(report_of(folder, command + " --contract")["written"]["nodes"] == nodes);
  }
  for (const char* field : {"'with inf'", "i64"}) {
    std::string message;
    for (const char* command : {"reeb", "features"}) {
      const auto run =
          run_crest(fmt::format("crest {} '{}' --field {}", command, *file, field), folder.path());
      CHECK(run.exit_code == 3);
      CHECK(is_one_line(run.err));
      CHECK(run.err.find("vertex ") != std::string::npos);
      if (message.empty()) message = run.err;
      CHECK(run.err == message);
    }
  }
  const auto unknown = run_crest("crest reeb '" + *file + "' --field nosuch", folder.path());
  CHECK(unknown.exit_code == 3);
  CHECK(unknown.err.find("'velocity'") == std::string::npos);
  const json area = report_of(folder, "reeb '" + *file + "' --field area");
  CHECK(warnings_of(area).find("each vertex has the mean over its faces") != std::string::npos);
  const auto quality = reported("ply_reeb_quality.ply");
  CHECK(report_of(folder, "features '" + *quality + "' --field quality")["field"] == "quality");
  CHECK(report_of(folder, "reeb '" + *quality + "' --field quality")["function"] == "quality");
  const json tets =
      report_of(folder, "reeb '" + *reported("msh_22_tets_beside.msh") + "' --field u");
  CHECK(tets["graph"]["nodes"] == 2);
  CHECK(warnings_of(tets).find("left out 1 tetrahedron") != std::string::npos);
}

TEST_CASE("normals are read from whatever mesh is read") {
  const TemporaryFolder folder;
  for (const char* name : {"n_list.ply", "n_unref.ply"}) {
    const auto file = reported(name);
    if (!file) return;
    CHECK(report_of(folder, "curvature '" + *file + "' --method np")["normals"] == "file");
  }
}

TEST_CASE("clean: the mesh of the other commands, its numbers the file's, rounding warned of") {
  const TemporaryFolder folder;
  write_text(folder / "q.off",
             "OFF\n6 3 0\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n4 1 2 3 4\n3 1 1 2\n3 3 2 1\n");
  const json report = report_of(folder, "clean q.off -o c.off");
  CHECK(report["vertex_numbers"] == json({1, 2, 3, 4}));
  CHECK(report["face_numbers"] == json({0, 0, 2}));
  CHECK(read_text(folder / "c.off").rfind("OFF\n4 3 0\n0 0 0\n", 0) == 0);
  CHECK(run_crest("crest clean q.off --weld -1", folder.path()).exit_code == 2);
  CHECK(run_crest("crest clean q.off --weld nan", folder.path()).exit_code == 2);
  REQUIRE(run_crest("crest sample ellipsoid --vertices 600 -o e.off", folder.path()).exit_code ==
          0);
  CHECK(report_of(folder, "clean e.off")["warnings"].empty());
  const auto lines = split_lines(read_text(folder / "e.off"));
  const std::size_t vertices = std::stoul(lines.at(1));
  for (const bool single : {false, true}) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::istringstream words(lines[i]);
      double x, y, z;
      if (i >= 2 && i < 2 + vertices && words >> x >> y >> z)
        text += single ? fmt::format("{} {} {}\n", double{static_cast<float>(x + 1e5)}, y, z)
                       : fmt::format("{:.2f} {:.2f} {:.2f}\n", x, y, z);
      else
        text += lines[i] + "\n";
    }
    write_text(folder / "r.off", text);
    const json rounded = report_of(folder, "clean r.off");
    REQUIRE(rounded["warnings"].size() >= 1);
    CHECK(warnings_of(rounded).find(single ? "multiples of 0.0078125" : "multiples of 0.01,") !=
          std::string::npos);
  }
}
