// SPDX-License-Identifier: GPL-3.0-or-later
// Ridges and umbilics of a mesh: fit Monge forms, extract the graph, check its certificate.
#include <cstdio>

#include "crest/algorithms/ridges/certificate.hpp"
#include "crest/algorithms/sampling/plain_surfaces.hpp"
#include "crest/certify/verify.hpp"

int main() {
  auto [points, triangles] = crest::sampling::icosphere(4);
  for (auto& p : points) p = {p[0], 1.5 * p[1], 2 * p[2]};
  const crest::kernel::TriangleMesh mesh(points, triangles);

  const auto fit = crest::ridges::fit_monge_forms(mesh, {});
  const auto [graph, certificate, digest] = crest::ridges::extract_certified(mesh, fit.forms);
  std::printf("Euler characteristic %d, index sum %g, %zu umbilics, %zu ridges\n",
              mesh.euler_characteristic(), graph.twice_index_sum / 2.0, graph.umbilics.size(),
              graph.ridges.size());

  const auto verdict = crest::certify::verify(certificate);
  std::printf("certificate %s: %s\n", crest::certify::hex(digest).c_str(),
              verdict.accepted ? "accepted" : verdict.reason.c_str());
  return verdict.accepted ? 0 : 1;
}
