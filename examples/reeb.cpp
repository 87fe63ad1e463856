// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph of a height on a surface of genus 3, and its certificate.
#include <cstdio>
#include <vector>

#include "crest/algorithms/reeb/certificate.hpp"
#include "crest/algorithms/sampling/plain_surfaces.hpp"
#include "crest/certify/verify.hpp"

int main() {
  const auto [points, triangles] = crest::sampling::plate(20, 3, true);
  std::vector<double> height;
  for (const auto& p : points) height.push_back(p[0] + 0.3 * p[1] + 0.1 * p[2]);
  const crest::kernel::QuadraticMesh mesh(points, triangles, height);

  const auto tiles = crest::reeb::tessellate(mesh);
  const auto graph = crest::reeb::reeb_graph(crest::reeb::ordered(tiles));
  std::printf("%zu nodes, %zu arcs, %u loops\n", graph.nodes.size(), graph.arcs.size(),
              graph.loops());

  const auto certificate = crest::reeb::make_certificate(mesh, tiles, graph);
  const auto verdict = crest::certify::verify(crest::certify::encode(certificate));
  for (const std::string& line : verdict.lines) std::printf("  %s\n", line.c_str());
  std::printf("%s\n", verdict.accepted ? "accepted" : verdict.reason.c_str());
  return verdict.accepted && graph.loops() == 3 ? 0 : 1;
}
