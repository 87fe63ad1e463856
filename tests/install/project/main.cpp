// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest program on the installed libraries: ridges of a subdivided octahedron.
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "algorithms/ridges/ridges.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace {

using crest::kernel::Index;
using crest::kernel::Triangle;
using crest::kernel::Vec3;

/// Splits every face into four, new vertices on the sides' midpoints.
void subdivide(std::vector<Vec3>& points, std::vector<Triangle>& faces) {
  std::map<std::pair<Index, Index>, Index> middle;
  const auto midpoint = [&](Index a, Index b) {
    const auto [at, made] =
        middle.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
    if (made) {
      const Vec3 p = points[a], q = points[b];
      points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
    }
    return at->second;
  };
  std::vector<Triangle> finer;
  for (const auto& [a, b, c] : faces) {
    const Index ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    for (const Triangle& f : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      finer.push_back(f);
  }
  faces = finer;
}

}  // namespace

int main() {
  std::vector<Vec3> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                 {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < 4; ++i) subdivide(points, faces);
  for (Vec3& p : points) {
    const double r = std::hypot(p[0], p[1], p[2]);
    p = {p[0] / r, 1.5 * p[1] / r, 2 * p[2] / r};
  }
  const crest::kernel::TriangleMesh mesh(points, faces);
  const auto fit = crest::ridges::fit_monge_forms(mesh, {});
  const auto graph = crest::ridges::extract_ridge_graph(mesh, fit.forms);
  std::printf("Euler characteristic %d, index sum %g, %zu umbilics, %zu ridges\n",
              mesh.euler_characteristic(), graph.twice_index_sum / 2.0, graph.umbilics.size(),
              graph.ridges.size());
  return graph.twice_index_sum == 2 * mesh.euler_characteristic() ? 0 : 1;
}
