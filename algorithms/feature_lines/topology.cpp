// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/topology.hpp"

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::feature_lines {
namespace {

/// Components of the subcomplex that are whole closed surfaces: no vertex on the boundary or with
/// a neighbour outside.
Index closed_components(const kernel::TriangleMesh& mesh, const Marks& marks, std::uint8_t mark,
                        kernel::DisjointSets& parts) {
  Marks open(mesh.vertex_count(), 0);
  for (const kernel::Edge& e : mesh.edges())
    if (marks[e.v0] != marks[e.v1]) open[parts.find(marks[e.v0] == mark ? e.v0 : e.v1)] = 1;
  Index closed = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v] == mark && mesh.on_boundary(v)) open[parts.find(v)] = 1;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v] == mark && parts.find(v) == v && !open[v]) ++closed;
  return closed;
}

}  // namespace

Betti betti_numbers(const kernel::TriangleMesh& mesh, const Marks& marks, std::uint8_t mark) {
  kernel::DisjointSets parts(mesh.vertex_count());
  Betti betti;
  for (Index v = 0; v < mesh.vertex_count(); ++v) betti.b0 += marks[v] == mark ? 1 : 0;
  std::int64_t euler = betti.b0;
  for (const kernel::Edge& e : mesh.edges()) {
    if (marks[e.v0] != mark || marks[e.v1] != mark) continue;
    --euler;
    if (parts.unite(e.v0, e.v1)) --betti.b0;
  }
  for (const kernel::Triangle& f : mesh.faces())
    euler += marks[f[0]] == mark && marks[f[1]] == mark && marks[f[2]] == mark ? 1 : 0;
  betti.b2 = closed_components(mesh, marks, mark, parts);
  betti.euler = static_cast<int>(euler);
  betti.b1 = static_cast<Index>(std::int64_t{betti.b0} + betti.b2 - euler);
  return betti;
}

}  // namespace crest::feature_lines
