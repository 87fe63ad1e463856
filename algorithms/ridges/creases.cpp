// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/creases.hpp"

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::ridges {
namespace {

using kernel::Index;
using kernel::Vec3;
using kernel::operator-;

constexpr double kCosine = 0x1.8836fa2cf5039p-1;  // of 40 degrees

bool sharp(const kernel::Edge& e, const std::vector<Vec3>& normals) {
  if (e.f0 == kernel::kNone || e.f1 == kernel::kNone) return false;
  const Vec3 &m = normals[e.f0], &n = normals[e.f1];
  return kernel::dot(m, n) < kCosine * kernel::norm(m) * kernel::norm(n);
}

}  // namespace

std::vector<std::uint8_t> crease_vertices(const kernel::TriangleMesh& mesh) {
  std::vector<Vec3> normals;
  const std::vector<Vec3>& p = mesh.points();
  for (const auto& [a, b, c] : mesh.faces())
    normals.push_back(kernel::cross(p[b] - p[a], p[c] - p[a]));
  kernel::DisjointSets sets(mesh.vertex_count());
  std::vector<Index> edges(mesh.vertex_count());  // at a vertex, then of a net by its name
  for (const kernel::Edge& e : mesh.edges()) {
    if (!sharp(e, normals)) continue;
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
