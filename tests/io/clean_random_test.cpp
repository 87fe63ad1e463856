// SPDX-License-Identifier: GPL-3.0-or-later
// Random soups: what comes out is a manifold, maps lead back to the file, cleaning twice is
// cleaning once; and the rule of polygons.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "io/clean/polygon_cutter.hpp"
#include "kernel/geometry/quadratic_mesh.hpp"
#include "kernel/geometry/triangle_mesh.hpp"
#include "tests/io/clean_soups.hpp"
#include "tests/support/random.hpp"

using namespace crest::tests;
using crest::io::PolygonCutter;

namespace {

/// Few points on a coarse lattice: faces repeat, meet, are flat and one-sided all the time.
Soup random_soup(Random& random) {
  std::vector<Vec3> points;
  const std::size_t n = 4 + random() % 12;
  for (std::size_t v = 0; v < n; ++v) {
    Vec3& p = points.emplace_back();
    for (double& x : p) x = static_cast<double>(random() % 3);
  }
  std::vector<Face> faces;
  for (std::size_t f = 0, many = 1 + random() % 20; f < many; ++f) {
    Face& face = faces.emplace_back();
    for (std::size_t k = 0, corners = 2 + random() % 4; k < corners; ++k)
      face.push_back(static_cast<crest::io::Cells::Node>(random() % n));
  }
  return soup_of(points, faces);
}

/// A corner is one of the face's own cell, at the same place though welding or collapsing gives it
/// another number; but a flip gives one to each of two faces, and a vertex may be collapsed into
/// one that is elsewhere.
void check_maps(const Soup& soup, const Surface& s, const crest::io::CleanUp& done) {
  for (Index v = 0; v < s.vertex_count(); ++v) CHECK(s.points[v] == soup.points[s.point_of[v]]);
  std::set<Index> foreign;
  for (Index f = 0; f < s.face_count(); ++f) {
    const auto nodes = soup.cells.nodes(s.cell_of[f]);
    for (const Index v : s.faces[f])
      if (std::none_of(nodes.begin(), nodes.end(), [&](crest::io::Cells::Node node) {
            return soup.points[static_cast<std::size_t>(node)] == s.points[v];
          }))
        foreign.insert(v);
  }
  CHECK(foreign.size() <= 2 * done.flipped_edges + done.collapsed_edges);
}

using Points = std::vector<Vec3>;

std::vector<Triangle> cut(const Points& polygon, std::vector<Index> numbers = {}) {
  if (numbers.empty()) {
    numbers.resize(polygon.size());
    std::iota(numbers.begin(), numbers.end(), Index{0});
  }
  PolygonCutter cutter;
  crest::io::EdgeSet edges;
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : cutter.cut(polygon, numbers, edges))
    triangles.push_back({numbers[a], numbers[b], numbers[c]});
  return triangles;
}

double twice_area(const Points& p, const Triangle& t) {
  const Vec3 &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Each with its lowest corner first, sorted.
std::set<Triangle> as_set(const std::vector<Triangle>& triangles) {
  std::set<Triangle> set;
  for (Triangle t : triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    set.insert(t);
  }
  return set;
}

}  // namespace

TEST_CASE("random soups become manifolds that lead back to the file, once and for all", "[io]") {
  Random random(kSeed);
  std::size_t good = 0, cut_edges = 0, collapsed = 0, split = 0;
  for (int trial = 0; trial < 2000 * multiplier(); ++trial) {
    const Soup soup = random_soup(random);
    crest::io::CleanOptions options;
    options.split = true;
    options.outward = trial % 2 == 0;
    if (trial % 3 == 0) options.weld = 0;
    for (const Purpose purpose : {Purpose::geometry, Purpose::function}) {
      const Cleaned c = cleaned(soup, options, purpose);
      if (!c.error.empty()) continue;
      INFO("trial " << trial);
      ++good;
      cut_edges += c.done.cut_edges;
      split += c.done.split_vertices;
      collapsed += c.done.collapsed_edges + c.done.flipped_edges + c.done.trimmed_faces;
      if (purpose == Purpose::geometry)
        CHECK_NOTHROW(crest::kernel::TriangleMesh(c.surface.points, c.surface.faces));
      else
        CHECK_NOTHROW(crest::kernel::QuadraticMesh(
            c.surface.points, c.surface.faces, std::vector<double>(c.surface.points.size(), 0.0)));
      check_maps(soup, c.surface, c.done);
      options.weld.reset();  // vertices split at one place are to stay apart
      const Cleaned again = cleaned(soup_of(c.surface), options, purpose);
      CHECK(again.surface.points == c.surface.points);
      CHECK(again.surface.faces == c.surface.faces);
      CHECK(again.done.cut_edges + again.done.split_vertices + again.done.collapsed_edges == 0);
    }
  }
  CHECK(good > 1000);
  CHECK(cut_edges > 100);
  CHECK(split > 100);
  CHECK(collapsed > 20);
}

TEST_CASE("polygons: the shortest ear first, wherever the list begins", "[io]") {
  // The shorter diagonal; not one that folds; of equal ones the ear at the lowest number.
  CHECK(as_set(cut({{0, 0, 0}, {3, 0, 0}, {4, 2, 0}, {1, 2, 0}})) ==
        std::set<Triangle>{{0, 1, 3}, {1, 2, 3}});
  CHECK(as_set(cut({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}})) ==
        std::set<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(as_set(cut({{0, 0, 0}, {4, 4, 0}, {1, 1, 0}, {4, 0, 0}})).size() == 2);  // straight at 2
  // A comb, whose shortest diagonals are outside.
  const Points comb = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {4, 1, 0},
                       {3, 5, 0}, {2, 1, 0}, {1, 5, 0}, {0.5, 1, 0}};
  const auto pieces = cut(comb);
  CHECK(pieces.size() == 6);
  double sum = 0;
  for (const Triangle& t : pieces) {
    CHECK(twice_area(comb, t) > 0);
    sum += twice_area(comb, t);
  }
  CHECK(sum == 27.5);
  // Corners on straight sides make no flat triangle.
  const Points square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                         {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  for (const Triangle& t : cut(square)) CHECK(twice_area(square, t) > 0);
  // Nothing to be seen: still n - 2 triangles.
  CHECK(cut(Points(9, Vec3{1, 1, 1})).size() == 7);
  CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}}).size() == 3);
}

TEST_CASE("random star-shaped polygons are cut into their area, alike from every corner", "[io]") {
  Random random(kSeed + 1);
  for (int trial = 0; trial < 300 * multiplier(); ++trial) {
    const std::size_t n = 4 + random() % 20;
    Points polygon;
    double area = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double r = 1 + static_cast<double>(random() % 8),
                   t = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
      polygon.push_back(
          {r * std::cos(t), r * std::sin(t), 0.01 * static_cast<double>(random() % 5)});
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % n];
      area += p[0] * q[1] - p[1] * q[0];
    }
    INFO("trial " << trial << ", " << n << " corners");
    const auto pieces = cut(polygon);
    REQUIRE(pieces.size() == n - 2);
    double sum = 0;
    for (const Triangle& t : pieces) sum += std::fabs(twice_area(polygon, t));
    CHECK(sum == Approx(area));
    std::vector<Index> numbers(n);
    std::iota(numbers.begin(), numbers.end(), Index{0});
    const std::size_t by = 1 + random() % (n - 1);
    Points rotated = polygon;
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(by), rotated.end());
    std::rotate(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(by), numbers.end());
    CHECK(as_set(cut(rotated, numbers)) == as_set(pieces));
  }
}

TEST_CASE("a polygon of many corners takes no time", "[io]") {
  Points circle;
  constexpr std::size_t n = 50000;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * static_cast<double>(i) / n, r = i % 2 == 0 ? 1 : 0.99;
    circle.push_back({r * std::cos(t), r * std::sin(t), 0});
  }
  CHECK(cut(circle).size() == n - 2);
}
