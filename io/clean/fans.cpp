// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/fans.hpp"

#include "io/formats/files.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::io {

using kernel::Index;

std::size_t split_fans(Surface& surface, const Neighbours& across) {
  const Index corners = 3 * surface.face_count();
  kernel::DisjointSets fans(corners);
  for (Index f = 0; f < across.size(); ++f) {
    for (Index k = 0; k < 3; ++k) {
      const Neighbour& n = across[f][k];
      if (n.face == kernel::kNone || n.face < f) continue;
      const Index ours[2] = {3 * f + k, 3 * f + (k + 1) % 3};
      const Index theirs[2] = {3 * n.face + n.side, 3 * n.face + (n.side + 1u) % 3};
      fans.unite(ours[0], theirs[n.agrees ? 1 : 0]);
      fans.unite(ours[1], theirs[n.agrees ? 0 : 1]);
    }
  }
  // A set is named by its first corner, which comes first.
  std::vector<Index> vertex_of_fan(corners);
  std::vector<std::uint8_t> seen(surface.points.size(), 0);
  std::size_t several = 0;
  for (Index c = 0; c < corners; ++c) {
    Index& v = surface.faces[c / 3][c % 3];
    const Index fan = fans.find(c);
    if (fan == c) {
      vertex_of_fan[c] = v;
      if (seen[v] == 0) {
        seen[v] = 1;
      } else {
        several += seen[v] == 1;
        seen[v] = 2;
        vertex_of_fan[c] = surface.vertex_count();
        surface.points.push_back(kernel::Vec3(surface.points[v]));
        surface.point_of.push_back(Index{surface.point_of[v]});
      }
    }
    v = vertex_of_fan[fan];
  }
  if (surface.points.size() >= kernel::kNone) fail("mesh", "has too many vertices", "split it");
  return several;
}

}  // namespace crest::io
