// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/certificate.hpp"

namespace crest::feature_lines {
namespace {

certify::BettiRecord record_of(const Betti& b) {
  return {b.euler, b.b0, b.b1, b.b2};
}

}  // namespace

certify::FeaturesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                  const Thinning& thinning) {
  certify::FeaturesMeshCertificate c;
  c.faces = mesh.faces();
  c.positions = mesh.points();
  for (kernel::Vec3& p : c.positions)
    for (double& x : p) x += 0.0;  // one form of zero
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

}  // namespace crest::feature_lines
