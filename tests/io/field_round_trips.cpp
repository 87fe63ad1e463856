// SPDX-License-Identifier: GPL-3.0-or-later
// Functions on surfaces: what a file holds is what is read.
#include <catch2/catch.hpp>
#include <cmath>

#include "io/read/quadratic_reader.hpp"
#include "io/write/mesh_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/quadratic_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using crest::io::FunctionSource;
using crest::io::QuadraticFile;
using crest::io::read_quadratic_mesh;
using crest::io::read_quadratic_mesh_bytes;
using crest::kernel::Expression;
using crest::kernel::kNone;
using crest::kernel::QuadraticMesh;
using namespace crest::tests;

double wavy(const Vec3& p) {
  return std::sin(3 * p[0]) + p[1] * p[2] - 0.1 * p[2];
}

void check_same(const QuadraticMesh& a, const QuadraticMesh& b) {
  CHECK(a.points() == b.points());
  CHECK(a.faces() == b.faces());
  CHECK(a.values() == b.values());
  CHECK(a.edge_values() == b.edge_values());
}

FunctionSource expression(const std::string& text) {
  return {"", Expression::parse(text, {"x", "y", "z"}), false};
}

}  // namespace

TEST_CASE("quadratic triangles read back exactly from VTU and Gmsh files", "[io]") {
  for (const QuadraticGrid& grid :
       {torus_grid(7, 5, wavy), square_grid(3, wavy), moebius_grid(9, wavy)}) {
    const QuadraticMesh mesh = mesh_of(grid);
    const std::pair<const char*, std::string> files[] = {
        {"a.vtu", vtu_text(grid)}, {"a.msh", msh_text(grid, 2)}, {"B.MSH", msh_text(grid, 4)}};
    for (const auto& [name, text] : files) {
      INFO(name);
      for (const char* field : {"", "T"}) {
        const QuadraticFile file = read_quadratic_mesh_bytes(name, text, {field, {}, false});
        check_same(file.mesh, mesh);
        CHECK(file.function == "T");
        // The Gmsh text has a point beside the triangles.
        CHECK(file.warnings.size() == (std::string(name) == "a.vtu" ? 0 : 1));
      }
    }
  }
}

TEST_CASE("linear faces among quadratic ones have their ends' means in between", "[io]") {
  // Corners at 0..3, one quadratic face; the side the two share is straight in its values.
  QuadraticGrid grid{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                     {{0, 1, 2, 4, 5, 6}, {1, 3, 2, kNone, kNone, kNone}},
                     {0, 1, 4, 9, 7, 2.5, -3}};
  for (const std::string name : {"a.vtu", "a.msh"}) {
    const std::string text = name == "a.vtu" ? vtu_text(grid) : msh_text(grid, 4);
    const QuadraticMesh mesh = read_quadratic_mesh_bytes(name, text, {}).mesh;
    CHECK(mesh.vertex_count() == 4);
    // Edges 01 02 12 13 23.
    CHECK(mesh.edge_values() == std::vector<double>{7, -3, 2.5, 5, 6.5});
    CHECK(read_quadratic_mesh_bytes(name, text, {"T", {}, true}).mesh.linear());
    // An expression has its own value in the middle of every side.
    const QuadraticMesh sampled = read_quadratic_mesh_bytes(name, text, expression("x*y")).mesh;
    CHECK(sampled.edge_values() == std::vector<double>{0, 0, 1, 2, 2});
  }
}

TEST_CASE("linear files give functions linear on each face", "[io]") {
  QuadraticGrid grid = square_grid(2, wavy);
  for (auto& cell : grid.cells) cell[3] = cell[4] = cell[5] = kNone;
  for (const std::string& text : {vtu_text(grid), msh_text(grid, 2)}) {
    const char* name = text[0] == '<' ? "a.vtu" : "a.msh";
    const QuadraticFile file = read_quadratic_mesh_bytes(name, text, {});
    CHECK(file.mesh.linear());
    CHECK(file.mesh.vertex_count() == 9);
    REQUIRE_FALSE(file.warnings.empty());
    CHECK(file.warnings.back() == "left out 16 vertices that no face uses");
  }
}

TEST_CASE("expressions are sampled at vertices and midpoints of any triangle mesh", "[io]") {
  const TemporaryFolder folder;
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, 0, 5}};
  const std::vector<crest::kernel::Triangle> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.vtp"}) {
    INFO(name);
    crest::io::write_mesh(folder / name, points, faces);
    const QuadraticFile file = read_quadratic_mesh(folder / name, expression("x^2 + y - z"));
    CHECK(file.function == "x^2 + y - z");
    CHECK(file.mesh.values() == std::vector<double>{0, 1, 3, -5});
    // Edges 01 02 03 12 13 23.
    CHECK(file.mesh.edge_values() == std::vector<double>{0.25, 1.5, -2.5, 1.75, -2.25, -1});
    FunctionSource linear = expression("x^2 + y - z");
    linear.linear = true;
    CHECK(read_quadratic_mesh(folder / name, linear).mesh.linear());
    // Linear on every face: no samples in between, whose rounding would show.
    CHECK(read_quadratic_mesh(folder / name, expression("0.1*x + y/3 - z")).mesh.linear());
  }
  // On curved faces it is quadratic, and beside them its value in the middle is theirs.
  QuadraticGrid grid{
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}},
      {{0, 1, 2, 4, 5, 6}, {1, 3, 2, kNone, kNone, kNone}},
      {0, 0, 0, 0, 0, 0, 0}};
  const QuadraticMesh mixed =
      read_quadratic_mesh_bytes("a.vtu", vtu_text(grid), expression("x + 2*y")).mesh;
  CHECK(mixed.edge_values() == std::vector<double>{2, 2, 3, 4, 5});
}

TEST_CASE("faces need not be oriented alike, nor the surface be orientable", "[io]") {
  const std::string two = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n";
  CHECK(read_quadratic_mesh_bytes("a.off", two, expression("x")).warnings.empty());
  const QuadraticMesh strip =
      read_quadratic_mesh_bytes("a.vtu", vtu_text(moebius_grid(5, wavy)), {}).mesh;
  CHECK(strip.vertex_count() + strip.face_count() == strip.edge_count());
}

TEST_CASE("curved sides are read, with a warning", "[io]") {
  QuadraticGrid grid = square_grid(1, wavy);
  for (std::size_t v = 4; v < grid.nodes.size(); ++v) grid.nodes[v][2] += 0.2;
  const QuadraticFile file = read_quadratic_mesh_bytes("a.vtu", vtu_text(grid), {});
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].starts_with("6 sides are curved"));
  CHECK_FALSE(file.mesh.linear());
}
