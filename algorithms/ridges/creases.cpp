// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/creases.hpp"

#include <tbb/blocked_range.h>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

using kernel::Index;
using kernel::Vec3;
using kernel::operator-;

constexpr double kCosine = 0x1.8836fa2cf5039p-1;  // of 40 degrees

Vec3 normal_of(const kernel::TriangleMesh& mesh, Index f) {
  const auto [a, b, c] = mesh.faces()[f];
  const std::vector<Vec3>& p = mesh.points();
  return kernel::cross(p[b] - p[a], p[c] - p[a]);
}

bool sharp(const kernel::TriangleMesh& mesh, const kernel::Edge& e) {
  if (e.f0 == kernel::kNone || e.f1 == kernel::kNone) return false;
  const Vec3 m = normal_of(mesh, e.f0), n = normal_of(mesh, e.f1);
  return kernel::dot(m, n) < kCosine * kernel::norm(m) * kernel::norm(n);
}

}  // namespace

std::vector<std::uint8_t> crease_vertices(const kernel::TriangleMesh& mesh) {
  std::vector<std::uint8_t> is_sharp(mesh.edge_count());
  kernel::parallel_for(tbb::blocked_range<Index>(0, mesh.edge_count(), 8192),
                       [&](const auto& range) {
                         for (Index e = range.begin(); e != range.end(); ++e)
                           is_sharp[e] = sharp(mesh, mesh.edges()[e]);
                       });
  kernel::DisjointSets sets(mesh.vertex_count());
  std::vector<Index> edges(mesh.vertex_count());  // at a vertex, then of a net by its name
  for (Index i = 0; i < mesh.edge_count(); ++i) {
    if (!is_sharp[i]) continue;
    const kernel::Edge& e = mesh.edges()[i];
    sets.unite(e.v0, e.v1);
    ++edges[e.v0];
  }
  std::vector<Index> of_net(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) of_net[sets.find(v)] += edges[v];
  std::vector<std::uint8_t> crease(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    crease[v] = of_net[sets.find(v)] >= static_cast<Index>(kSmallestSupport);
  return crease;
}

}  // namespace crest::ridges
