// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of area zero: each way out, and what keeps the topology from it.
#include "io/clean/collapse.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/geometry/triangle_mesh.hpp"
#include "kernel/predicates/collinear.hpp"
#include "tests/io/clean_soups.hpp"
#include "tests/support/random.hpp"

using namespace crest::tests;
using crest::kernel::TriangleMesh;

namespace {

int euler(const Surface& s) {
  return TriangleMesh(s.points, s.faces).euler_characteristic();
}

/// A bipyramid over n corners, as a surface with nothing to mend.
Surface bipyramid(int n) {
  std::vector<Vec3> points = {{0, 0, 1}, {0, 0, -1}};
  std::vector<Face> faces;
  for (int i = 0; i < n; ++i) {
    points.push_back({std::cos(6.283185307 * i / n), std::sin(6.283185307 * i / n), 0});
    faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  return cleaned(soup_of(points, faces)).surface;
}

/// A copy of vertex v is put on edge v-w: both faces there become two, two of them of area zero.
void double_vertex(Surface& s, Index v, Index w) {
  const Index copy = s.vertex_count();
  s.points.push_back(Vec3(s.points[v]));
  s.point_of.push_back(copy);
  for (Index f = 0, n = s.face_count(); f < n; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      Triangle& t = s.faces[f];
      const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      if (!((a == v && b == w) || (a == w && b == v))) continue;
      t = {a, copy, c};
      s.faces.push_back({copy, b, c});
      s.cell_of.push_back(Index{s.cell_of[f]});
      break;
    }
  }
}

}  // namespace

TEST_CASE("an edge of zero length is collapsed, the lower vertex stays", "[io]") {
  Surface s = bipyramid(5);
  const auto faces = s.faces;
  double_vertex(s, 3, 4);
  CleanUp done;
  CHECK(collapse_flat_faces(s, done).empty());
  CHECK(done.collapsed_edges == 1);
  CHECK(s.points.size() == 7);
  CHECK(s.faces.size() == 10);
  CHECK(euler(s) == 2);
}

TEST_CASE("a middle corner on the longest side: the edge is flipped, nothing moves", "[io]") {
  // 4 is on the edge 1-2 of the square's upper triangle; face 1 is flat.
  const std::vector<Vec3> points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, 0}};
  const Cleaned c = cleaned(soup_of(points, {{0, 1, 2}, {1, 4, 2}, {1, 3, 4}, {4, 3, 2}}));
  CHECK(c.error == "");
  CHECK(c.done.flipped_edges == 1);
  CHECK(c.done.collapsed_edges == 0);
  CHECK(c.surface.points == points);
  CHECK(c.surface.faces.size() == 4);
  CHECK(euler(c.surface) == 1);
}

TEST_CASE("a flat face whose longest side is at the boundary is left out", "[io]") {
  const std::vector<Vec3> points = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}};
  const Cleaned c = cleaned(soup_of(points, {{0, 2, 3}, {2, 1, 3}, {0, 1, 2}}));
  CHECK(c.error == "");
  CHECK(c.done.trimmed_faces == 1);
  CHECK(c.surface.faces == std::vector<Triangle>{{0, 2, 3}, {2, 1, 3}});
  CHECK(c.surface.cell_of == std::vector<Index>{0, 1});
}

TEST_CASE("flat faces in chains wait for each other", "[io]") {
  // A fan of flat faces below one triangle: all corners on its longest side.
  constexpr int n = 40;
  std::vector<Vec3> points = {{0, 0, 0}, {n, 0, 0}, {0.5 * n, -5, 0}, {0.5 * n, 5, 0}};
  std::vector<Face> faces = {{0, 2, 1}};
  Index last = 1;
  for (int i = 1; i < n; ++i) {
    points.push_back({n - static_cast<double>(i), 0, 0});
    const auto next = static_cast<Index>(points.size() - 1);
    faces.push_back({0, last, next});
    faces.push_back({last, 3, next});
    last = next;
  }
  faces.push_back({last, 3, 0});
  const Cleaned c = cleaned(soup_of(points, faces));
  CHECK(c.error == "");
  CHECK(c.surface.points.size() == points.size());
  CHECK(c.surface.faces.size() == faces.size());
  CHECK(c.done.flipped_edges == n - 1);
  CHECK(euler(c.surface) == 1);
}

TEST_CASE("what no step may mend is named, and welding is a way", "[io]") {
  CHECK(cleaned(soup_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}))
            .error.starts_with("face 0: its area is exactly zero, and no edge of it can be "
                               "collapsed without a change of the surface's topology"));
  // Two tetrahedra glued at a triangle that is not there, one of its edges without length: a
  // collapse would pinch the neck.
  std::vector<Vec3> points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, -1, -1}, {3, 0, 0}};
  const std::vector<Face> neck = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  const Cleaned c = cleaned(soup_of(points, neck));
  CHECK(c.error.find("--weld 0") != std::string::npos);
  crest::io::CleanOptions options;
  options.weld = 0;
  CHECK(cleaned(soup_of(points, neck), options).error == "");
}

TEST_CASE("random vertices doubled again and again collapse to the surface they came from",
          "[io]") {
  Random random(kSeed);
  for (int trial = 0; trial < 100 * multiplier(); ++trial) {
    const int n = 4 + static_cast<int>(random() % 5);
    Surface s = bipyramid(n);
    const std::size_t points = s.points.size(), faces = s.faces.size();
    for (int i = 0; i < 12; ++i) {
      const Triangle& t = s.faces[random() % s.faces.size()];
      double_vertex(s, t[0], t[1]);
    }
    CleanUp done;
    INFO("trial " << trial);
    CHECK(collapse_flat_faces(s, done).empty());
    CHECK(euler(s) == 2);
    CHECK(s.points.size() == points);
    CHECK(s.faces.size() == faces);
    CHECK(done.collapsed_edges == 12);
    for (const auto& [a, b, c] : s.faces)
      CHECK_FALSE(crest::kernel::collinear(s.points[a], s.points[b], s.points[c]));
  }
}
