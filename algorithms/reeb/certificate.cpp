// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/certificate.hpp"

#include "algorithms/reeb/contraction.hpp"
#include "algorithms/reeb/cuts.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::reeb {
namespace {

/// Boundary edges form cycles: one for each class of vertices they join.
std::uint32_t count_boundary_loops(const kernel::QuadraticMesh& mesh) {
  kernel::DisjointSets parts(mesh.vertex_count());
  std::uint32_t edges = 0, joins = 0;
  for (const kernel::Edge& e : mesh.edges()) {
    if (e.f0 != kNone && e.f1 != kNone) continue;
    ++edges;
    joins += parts.unite(e.v0, e.v1);
  }
  return edges - joins;
}

/// Zero has one form in a certificate.
std::vector<double> without_minus_zero(const std::vector<double>& values) {
  std::vector<double> out = values;
  for (double& v : out) v += 0.0;
  return out;
}

}  // namespace

certify::ReebCertificate make_certificate(const kernel::QuadraticMesh& mesh,
                                          const TileComplex& tiles, const ReebGraph& graph) {
  certify::ReebCertificate c;
  c.faces = mesh.faces();
  c.positions = mesh.points();
  for (auto& point : c.positions)
    for (double& x : point) x += 0.0;
  c.values = without_minus_zero(mesh.values());
  c.edge_values = without_minus_zero(mesh.edge_values());
  c.euler_characteristic = static_cast<std::int32_t>(mesh.vertex_count()) -
                           static_cast<std::int32_t>(mesh.edge_count()) +
                           static_cast<std::int32_t>(mesh.face_count());
  c.boundary_loops = count_boundary_loops(mesh);
  c.components = graph.components;
  c.line_critical = static_cast<std::uint32_t>(tiles.critical_edges.size());
  c.face_critical = static_cast<std::uint32_t>(tiles.critical_faces.size());
  c.tiles = static_cast<std::uint32_t>(tiles.tiles.size());
  c.order = tiles.order;
  c.critical_nodes.reserve(graph.nodes.size());
  for (const ReebNode& node : graph.nodes) {
    c.critical_nodes.push_back(node.vertex);
    c.minima += node.kind == NodeKind::minimum;
    c.maxima += node.kind == NodeKind::maximum;
    if (node.kind == NodeKind::saddle) c.saddles += node.multiplicity;
  }
  c.arcs.reserve(graph.arcs.size());
  for (const ReebArc& arc : graph.arcs) c.arcs.push_back({arc.lower, arc.upper});
  const TieCounts ties = count_ties(graph, tiles.rank, tiles.tied);
  c.tied_arcs = ties.arcs;
  c.contracted_nodes = ties.groups;
  for (const Index arc : choose_cuts(graph)) c.cuts.push_back({arc, graph.arcs[arc].strand});
  return c;
}

}  // namespace crest::reeb
