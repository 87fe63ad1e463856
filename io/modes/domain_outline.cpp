// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/modes/domain_outline.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace crest::io {

using namespace kernel;

std::vector<std::array<Vec3, 2>> domain_outline(const TetMesh& mesh) {
  const auto& points = mesh.points();
  struct Side {
    Index from, to, face;
    Vec3 normal;  ///< of length 1, to either side
  };
  std::vector<Side> sides;
  for (Index f = 0; f < mesh.faces().size(); ++f) {
    const auto& face = mesh.faces()[f];
    if (face.tets[1] != TetMesh::kNoTet) continue;
    const auto& c = face.corners;
    const Vec3 n = cross(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]);
    const double length = norm(n);
    if (!(length > 0)) continue;
    for (const auto& [i, k] : {std::pair{0, 1}, {0, 2}, {1, 2}})
      sides.push_back(
          {c[static_cast<std::size_t>(i)], c[static_cast<std::size_t>(k)], f, (1 / length) * n});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.from, a.to, a.face) < std::tie(b.from, b.to, b.face);
  });
  std::vector<std::array<Vec3, 2>> outline;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    if (a.from == b.from && a.to == b.to && std::fabs(dot(a.normal, b.normal)) < std::sqrt(0.75))
      outline.push_back({points[a.from], points[a.to]});
  }
  return outline;
}

}  // namespace crest::io
