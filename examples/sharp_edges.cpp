// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a plate with holes above 30 degrees, compared exactly, and the patches between them.
#include <cstdio>

#include "crest/algorithms/feature_lines/certificate.hpp"
#include "crest/algorithms/sampling/plain_surfaces.hpp"
#include "crest/certify/verify.hpp"

int main() {
  const auto [points, triangles] = crest::sampling::plate(20, 3, true);
  const crest::kernel::TriangleMesh mesh(points, triangles);
  const crest::kernel::DecimalAngle angle("30");
  const auto lines = crest::feature_lines::extract_sharp_lines(mesh, angle, {});
  std::printf("%u of %u edges above %s degrees, %u of exactly that angle; %zu patches\n",
              crest::feature_lines::count(lines.sharp), mesh.edge_count(), angle.text().c_str(),
              lines.ties, lines.graph.patch_sizes.size());

  const auto certificate = crest::feature_lines::make_certificate(mesh, angle, lines);
  const auto verdict = crest::certify::verify(crest::certify::encode(certificate));
  std::printf("%s\n", verdict.accepted ? "accepted" : verdict.reason.c_str());
  return verdict.accepted ? 0 : 1;
}
