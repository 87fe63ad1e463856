// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces the graph tests run over.
#include <functional>
#include <string>

#include "algorithms/reeb/reeb_graph.hpp"
#include "tests/support/closed_surfaces.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// A surface with the order that a function gives to its vertices.
class OrderedCase {
 public:
  OrderedCase(Surface s, const std::vector<double>& values)
      : surface_(std::move(s)), order_(order_of(values)) {}
  reeb::OrderedComplex complex() const { return {surface_.triangles, order_.rank, order_.order}; }
  const Surface& surface() const { return surface_; }

 private:
  Surface surface_;
  VertexOrder order_;
};

struct SurfaceRow {
  std::string name;
  int euler;
  int genus;  ///< -1: not closed and orientable
  std::function<Surface()> make;
};

inline const std::vector<SurfaceRow>& surface_rows() {
  using enum Sides;
  static const std::vector<SurfaceRow> rows = {
      {"torus", 0, 1, [] { return torus_surface(24, 24); }},
      {"genus 2", -2, 2, [] { return plate(13, 2, true); }},
      {"genus 3", -4, 3, [] { return plate(14, 3, true); }},
      {"genus 5", -8, 5, [] { return plate(12, 5, true); }},
      {"icosphere", 2, 0, [] { return icosphere(3); }},
      {"disk", 1, -1, [] { return strip(15, 17, open, open); }},
      {"disk with holes", -4, -1, [] { return plate(15, 5, false); }},
      {"annulus", 0, -1, [] { return strip(20, 9, joined, open); }},
      {"thin annulus", 0, -1, [] { return strip(12, 1, joined, open); }},
      {"Moebius strip", 0, -1, [] { return strip(21, 8, flipped, open); }},
      {"thin Moebius strip", 0, -1, [] { return strip(11, 1, flipped, open); }},
      {"Klein bottle", 0, -1, [] { return strip(16, 17, joined, flipped); }},
      {"projective plane", 1, -1, [] { return projective_plane(2); }},
      {"torus, disk, Moebius strip and sphere", 3, -1,
       [] {
         return disjoint(disjoint(torus_surface(7, 8), strip(6, 5, open, open)),
                         disjoint(strip(9, 3, flipped, open), icosphere(1)));
       }},
  };
  return rows;
}

/// A fan of n triangles around vertex 0, with a second ring around it; or a half of that.
inline Surface wheel(unsigned n, bool closed) {
  Surface s;
  s.points.push_back({0, 0, 0});
  const unsigned rim = closed ? n : n + 1;
  for (unsigned ring = 1; ring <= 2; ++ring)
    for (unsigned k = 0; k < rim; ++k) s.points.push_back({double(ring), double(k), 0});
  for (unsigned k = 0; k < n; ++k) {
    const auto a = 1 + k, b = 1 + (k + 1) % rim, c = a + rim, d = b + rim;
    s.triangles.insert(s.triangles.end(), {{0u, a, b}, {a, c, d}, {a, d, b}});
  }
  return s;
}

/// Triangle; two of them; tetrahedron; octahedron without two opposite faces; the projective plane
/// of six vertices.
inline std::vector<Surface> tiny_surfaces() {
  const auto with = [](std::vector<kernel::Triangle> triangles) {
    kernel::Index n = 0;
    for (const auto& t : triangles) n = std::max({n, t[0] + 1, t[1] + 1, t[2] + 1});
    return Surface{std::vector<kernel::Vec3>(n), std::move(triangles)};
  };
  return {with({{0, 1, 2}}),
          with({{0, 1, 2}, {1, 2, 3}}),
          with({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}),
          with({{2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {0, 3, 5}}),
          with({{0, 1, 2}, {3, 4, 5}}),
          projective_plane(0)};
}

/// The triangles in another order, from other corners and in other directions.
inline Surface turned_at_random(Surface s, Random& random) {
  std::shuffle(s.triangles.begin(), s.triangles.end(), random);
  for (auto& t : s.triangles) {
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    if (random() % 2) std::swap(t[0], t[1]);
  }
  return s;
}

inline bool same_graph(const reeb::ReebGraph& g, const reeb::ReebGraph& h) {
  const auto node = [](const reeb::ReebNode& n) {
    return std::tuple(n.vertex, n.kind, n.on_boundary, n.multiplicity, n.index);
  };
  const auto arc = [](const reeb::ReebArc& a) {
    return std::tuple(a.lower, a.upper, a.strand, a.open_below, a.open_above);
  };
  return g.components == h.components &&
         std::equal(g.nodes.begin(), g.nodes.end(), h.nodes.begin(), h.nodes.end(),
                    [&](const auto& a, const auto& b) { return node(a) == node(b); }) &&
         std::equal(g.arcs.begin(), g.arcs.end(), h.arcs.begin(), h.arcs.end(),
                    [&](const auto& a, const auto& b) { return arc(a) == arc(b); });
}

}  // namespace crest::tests
