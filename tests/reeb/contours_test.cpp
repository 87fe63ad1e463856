// SPDX-License-Identifier: GPL-3.0-or-later
// Level lines: as many paths and cycles as the graph has arcs at that level, on the conics.
#include "algorithms/reeb/contours.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/conic_arc.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/quadratic_files.hpp"

namespace {

using namespace crest::reeb;
using namespace crest::tests;
using crest::kernel::QuadraticMesh;

struct Lines {
  std::size_t paths = 0, cycles = 0;
  friend bool operator==(const Lines&, const Lines&) = default;
};

Lines count(const std::vector<Contour>& contours) {
  Lines lines;
  for (const Contour& c : contours) ++(c.closed ? lines.cycles : lines.paths);
  return lines;
}

/// The arcs that a level between the ranks below - 1 and below crosses.
Lines expected(const TileComplex& tiles, const ReebGraph& graph, Index below) {
  Lines lines;
  for (const ReebArc& arc : graph.arcs) {
    const Index low = tiles.rank[graph.nodes[arc.lower].vertex];
    const Index high = tiles.rank[graph.nodes[arc.upper].vertex];
    if (low < below && high >= below) ++(arc.open_below ? lines.paths : lines.cycles);
  }
  return lines;
}

/// Levels at, between and beyond the nodes' values.
std::vector<double> levels_of(const QuadraticMesh& mesh, const TileComplex& tiles, Draw& d) {
  std::vector<double> levels = {-1e9, 1e9};
  for (int i = 0; i < 6; ++i) {
    const auto pick = [&] {
      const int n = static_cast<int>(mesh.vertex_count());
      return mesh.values()[static_cast<std::size_t>(d.integer(0, n - 1))];
    };
    const double a = pick(), b = pick();
    levels.insert(levels.end(), {a, 0.5 * a + 0.5 * b});
  }
  for (const NodePlace& place : node_places(mesh, tiles))
    if (d.integer(0, 40) == 0) levels.push_back(place.value);
  return levels;
}

void check_counts(const QuadraticMesh& mesh, Draw& d) {
  const TileComplex tiles = tessellate(mesh);
  const ReebGraph graph = reeb_graph(ordered(tiles));
  for (const double level : levels_of(mesh, tiles, d)) {
    INFO("level " << level);
    const Index below = nodes_below(mesh, tiles, level);
    for (const Index v : {below == 0 ? kNone : tiles.order[below - 1],
                          below == tiles.node_count() ? kNone : tiles.order[below]}) {
      if (v == kNone) continue;
      CHECK((exact_node_value(mesh, tiles, v) < level) == (tiles.rank[v] < below));
    }
    const auto lines = contours(mesh, tiles, level);
    CHECK(count(lines) == expected(tiles, graph, below));
    for (const Contour& line : lines) {
      for (const auto& p : line.points) {
        for (const double x : p)
          if (!std::isfinite(x)) FAIL("a place is not finite");
      }
    }
  }
}

}  // namespace

TEST_CASE("a level has a line for every arc that passes it, open and closed alike", "[reeb]") {
  Draw d(71);
  for (std::uint64_t i = 0; i < scaled(40); ++i) {
    INFO("trial " << i);
    const auto noise = [&](const Vec3&) { return d.uniform(); };
    const auto ties = [&](const Vec3&) -> double { return d.integer(-2, 2); };
    check_counts(mesh_of(square_grid(4, noise)), d);
    check_counts(mesh_of(square_grid(4, ties)), d);
    check_counts(mesh_of(torus_grid(5, 4, noise)), d);
    check_counts(mesh_of(torus_grid(5, 4, ties)), d);
    check_counts(mesh_of(moebius_grid(6, noise)), d);
    check_counts(mesh_of(square_grid(1, ties)), d);
  }
}

TEST_CASE("lines of a quadratic polynomial lie on its conics", "[reeb]") {
  struct Case {
    double xx, xy, yy, x, y;
  };
  // An ellipse around 0, one off the grid, hyperbolas, a parabola, parallel lines.
  for (const Case& k : {Case{1, 0, 1, 0, 0}, Case{1, 0.3, 2, 0.25, -0.4}, Case{1, 0, -1, 0.1, 0},
                        Case{0.2, 1, 0.1, 0, 0}, Case{1, 0, 0, 0, -1}, Case{1, 2, 1, 0.5, 0.5}}) {
    const auto f = [&](const Vec3& p) {
      return k.xx * p[0] * p[0] + k.xy * p[0] * p[1] + k.yy * p[1] * p[1] + k.x * p[0] + k.y * p[1];
    };
    for (const Index n : {1u, 3u, 8u}) {
      const QuadraticMesh mesh = mesh_of(square_grid(n, f));
      const TileComplex tiles = tessellate(mesh);
      for (const double level : {-0.31, 0.05, 0.21, 0.5, 0.9}) {
        INFO("n " << n << ", level " << level << ", form " << k.xx << " " << k.xy << " " << k.yy);
        for (const Contour& line : contours(mesh, tiles, level)) {
          for (const auto& p : line.points) {
            CHECK(f(p) == Approx(level).margin(1e-9));
            CHECK(std::max(std::abs(p[0]), std::abs(p[1])) <= 1 + 1e-9);
          }
        }
      }
    }
  }
}

TEST_CASE("a circle within one face is closed, round and complete", "[reeb]") {
  // Its centre is in a face of the coarsest grid, away from the diagonal.
  const auto f = [](const Vec3& p) {
    const double x = p[0] - 0.4, y = p[1] + 0.4;
    return x * x + y * y;
  };
  const QuadraticMesh mesh = mesh_of(square_grid(1, f));
  const TileComplex tiles = tessellate(mesh);
  const auto lines = contours(mesh, tiles, 0.04);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].closed);
  double length = 0;
  const auto& points = lines[0].points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &p = points[i], &q = points[(i + 1) % points.size()];
    length += std::hypot(q[0] - p[0], q[1] - p[1]);
  }
  CHECK(length == Approx(2 * 3.14159265 * 0.2).epsilon(0.01));
}

TEST_CASE("lines are the same for any order of the faces", "[reeb]") {
  const auto f = [](const Vec3& p) { return p[0] * p[1] + 0.3 * p[2] - 0.1 * p[0]; };
  QuadraticGrid grid = torus_grid(9, 7, f);
  const QuadraticMesh mesh = mesh_of(grid);
  std::rotate(grid.cells.begin(), grid.cells.begin() + 50, grid.cells.end());
  std::reverse(grid.cells.begin(), grid.cells.begin() + 20);
  const QuadraticMesh other = mesh_of(grid);
  for (const double level : {-0.7, 0.0, 0.4}) {
    const auto a = contours(mesh, tessellate(mesh), level);
    const auto b = contours(other, tessellate(other), level);
    REQUIRE(a.size() == b.size());
    CHECK(a.size() > 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK(a[i].closed == b[i].closed);
      CHECK(a[i].points == b[i].points);
    }
  }
}

TEST_CASE("an arc between two points of a conic stays on it", "[reeb]") {
  const FaceFunction f = face_function({0, 1, 1}, {0.25, 0.5, 0.25});  // s^2 + t^2
  CHECK(f.at({0.3, 0.4}) == Approx(0.25));
  std::vector<Vec2> arc;
  sample_arc(f, 0.25, {0.5, 0}, {0, 0.5}, 4, arc);
  CHECK(arc.size() == 15);
  for (const Vec2& p : arc) {
    CHECK(std::hypot(p[0], p[1]) == Approx(0.5));
    CHECK(p[0] > 0);
    CHECK(p[1] > 0);
  }
  arc.clear();
  const FaceFunction flat = face_function({0, 1, 2}, {0.5, 1.5, 1});
  sample_arc(flat, 0.5, {0.5, 0}, {0, 0.25}, 4, arc);
  CHECK(arc.empty());
  CHECK(crossing_parameter(0, 0.25, 1, 0.49, 0, 1) == Approx(0.7));
  CHECK(crossing_parameter(1, 0.25, 0, 0.49, 0, 1) == Approx(0.3));
  CHECK(crossing_parameter(0, 1, 0, 0.75, 0.5, 1) == Approx(0.75));
}
