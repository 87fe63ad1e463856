// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/certificate.hpp"

namespace crest::feature_lines {
namespace {

certify::BettiRecord record_of(const Betti& b) {
  return {b.euler, b.b0, b.b1, b.b2};
}

std::vector<kernel::Vec3> plain_positions(const kernel::TriangleMesh& mesh) {
  std::vector<kernel::Vec3> positions = mesh.points();
  for (kernel::Vec3& p : positions)
    for (double& x : p) x += 0.0;  // one form of zero
  return positions;
}

}  // namespace

certify::FeaturesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                  const Thinning& thinning) {
  certify::FeaturesMeshCertificate c;
  c.faces = mesh.faces();
  c.positions = plain_positions(mesh);
  c.marked_before = thinning.before;
  c.euler_characteristic = mesh.euler_characteristic();
  c.boundary_loops = mesh.boundary_loops();
  c.removed = thinning.removed;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (thinning.after[v]) c.marked_after.push_back(v);
  c.dropped = thinning.dropped;
  c.components = thinning.topology_after.marked.b0 - static_cast<Index>(thinning.dropped.size());
  c.betti = {
      record_of(thinning.topology_before.marked), record_of(thinning.topology_before.complement),
      record_of(thinning.topology_after.marked), record_of(thinning.topology_after.complement)};
  return c;
}

certify::SharpEdgesCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                const kernel::DecimalAngle& angle,
                                                const SharpLines& lines) {
  certify::SharpEdgesCertificate c;
  c.faces = mesh.faces();
  c.positions = plain_positions(mesh);
  c.angle = angle.text();
  c.euler_characteristic = mesh.euler_characteristic();
  c.boundary_loops = mesh.boundary_loops();
  std::vector<Index> degree(mesh.vertex_count(), 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!lines.sharp[e]) continue;
    c.sharp.push_back(e);
    ++degree[mesh.edges()[e].v0];
    ++degree[mesh.edges()[e].v1];
  }
  c.ties = lines.ties;
  for (const Index d : degree) {
    c.ends += d == 1;
    c.nodes += d >= 3;
  }
  c.patches = static_cast<Index>(build_edge_graph(mesh, lines.sharp).patch_sizes.size());
  return c;
}

}  // namespace crest::feature_lines
