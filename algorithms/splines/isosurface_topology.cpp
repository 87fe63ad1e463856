// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/isosurface_topology.hpp"

#include <bit>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::splines {

using kernel::Index;
using kernel::kNone;

namespace {

/// Points at the place of an earlier one.
std::size_t count_coincident(const std::vector<Vec3>& points) {
  std::vector<Index> table(std::bit_ceil(2 * points.size() + 1), kNone);
  std::size_t coincident = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t hash = 0;
    for (const double x : points[i]) {
      // 0 and -0 are one place.
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29;
    }
    std::size_t at = hash & (table.size() - 1);
    while (table[at] != kNone && points[table[at]] != points[i]) at = (at + 1) & (table.size() - 1);
    if (table[at] == kNone)
      table[at] = static_cast<Index>(i);
    else
      ++coincident;
  }
  return coincident;
}

}  // namespace

void describe(Isosurface& mesh, std::span<const MeshEdge> border) {
  const auto vertices = static_cast<Index>(mesh.points.size());
  kernel::DisjointSets parts(vertices), loops(vertices);
  for (const auto& t : mesh.triangles) {
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }
  mesh.components = parts.count();
  // Each loop joins all its vertices; others stay alone.
  std::vector<bool> at_border(vertices, false);
  std::size_t border_vertices = 0, joins = 0;
  for (const auto& [a, b] : border) {
    for (const Index v : {a, b})
      if (!at_border[v]) {
        at_border[v] = true;
        ++border_vertices;
      }
    joins += loops.unite(a, b);
  }
  mesh.boundary_loops = border_vertices - joins;
  const auto triangles = static_cast<std::int64_t>(mesh.triangles.size());
  const std::int64_t edges = (3 * triangles + static_cast<std::int64_t>(border.size())) / 2;
  mesh.euler_characteristic = std::int64_t{vertices} - edges + triangles;
  mesh.coincident = count_coincident(mesh.points);
}

}  // namespace crest::splines
