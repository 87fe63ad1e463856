// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/umbilic_regions.hpp"

#include <cmath>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::ridges {
namespace {

/// k1 - k2 < 3 sigma: the principal directions are not known.
bool doubtful(const kernel::MongeForm& m, const CurvatureError& e) {
  const double gap = m.k1 - m.k2, model = gap - (e.wide_k1 - e.wide_k2);
  return !(gap >= std::sqrt(9 * e.gap * e.gap + model * model));
}

std::vector<std::uint8_t> members(const kernel::TriangleMesh& mesh, const FitResult& fit,
                                  const RidgeGraph& graph) {
  std::vector<std::uint8_t> doubt(mesh.vertex_count()), in(mesh.face_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) doubt[v] = doubtful(fit.forms[v], fit.errors[v]);
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (const Index v : mesh.faces()[f]) in[f] |= doubt[v];
  for (const FaceIndex& i : graph.face_indices) in[i.face] = 1;
  for (const Umbilic& u : graph.umbilics)
    for (const Index f : u.patch) in[f] = 1;
  return in;
}

/// Euler characteristic of each region, as vertices - edges + faces.
void count_cells(const kernel::TriangleMesh& mesh, const std::vector<std::uint8_t>& in,
                 const std::vector<Index>& region_of, std::vector<UmbilicRegion>& regions) {
  std::vector<std::uint8_t> seen(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!in[f]) continue;
    UmbilicRegion& region = regions[region_of[mesh.faces()[f][0]]];
    ++region.faces;
    ++region.euler_characteristic;
    for (const Index v : mesh.faces()[f]) {
      region.euler_characteristic += seen[v] ? 0 : 1;
      seen[v] = 1;
    }
    for (const Index e : mesh.face_edges()[f]) {
      const kernel::Edge& edge = mesh.edges()[e];
      const Index other = edge.f0 == f ? edge.f1 : edge.f0;
      // A side counts with the lesser of its faces that are in.
      if (other == kernel::kNone || !in[other] || f < other) --region.euler_characteristic;
    }
  }
}

}  // namespace

std::vector<UmbilicRegion> umbilic_regions(const kernel::TriangleMesh& mesh, const FitResult& fit,
                                           const RidgeGraph& graph) {
  const std::vector<std::uint8_t> in = members(mesh, fit, graph);
  kernel::DisjointSets sets(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!in[f]) continue;
    const auto [a, b, c] = mesh.faces()[f];
    sets.unite(a, b);
    sets.unite(a, c);
  }
  std::vector<UmbilicRegion> regions;
  std::vector<Index> number(mesh.vertex_count(), kernel::kNone), region_of = number;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!in[f]) continue;
    Index& n = number[sets.find(mesh.faces()[f][0])];
    if (n == kernel::kNone) {
      n = static_cast<Index>(regions.size());
      regions.emplace_back();
    }
    for (const Index v : mesh.faces()[f]) region_of[v] = n;
  }
  count_cells(mesh, in, region_of, regions);
  for (const FaceIndex& i : graph.face_indices)
    regions[region_of[mesh.faces()[i.face][0]]].twice_index += i.twice_index;
  for (Index u = 0; u < graph.umbilics.size(); ++u)
    regions[region_of[mesh.faces()[graph.umbilics[u].face][0]]].umbilics.push_back(u);
  return regions;
}

}  // namespace crest::ridges
