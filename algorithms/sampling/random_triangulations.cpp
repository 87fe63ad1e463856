// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/random_triangulations.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "kernel/geometry/corner_table.hpp"

namespace crest::sampling {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;

std::vector<Triangle> stacked_sphere(Index v, std::mt19937_64& random) {
  std::vector<Triangle> faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (Index w = 4; w < v; ++w) {
    const auto f = random() % faces.size();
    const auto [a, b, c] = faces[f];
    faces[f] = {a, b, w};
    faces.push_back({b, c, w});
    faces.push_back({c, a, w});
  }
  return faces;
}

void flip_edges(std::vector<Triangle>& faces, Index vertices, std::size_t flips,
                std::mt19937_64& random) {
  const kernel::CornerTable table(vertices, faces);
  const auto sides = static_cast<Index>(3 * faces.size());
  const auto from = [&](Index h) { return faces[h / 3][h % 3]; };
  const auto key = [](Index a, Index b) { return std::pair<Index, Index>(std::minmax(a, b)); };
  std::vector<Index> twin(sides);
  std::set<std::pair<Index, Index>> edges;
  for (Index h = 0; h < sides; ++h) {
    twin[h] = table.opposite(h);
    edges.insert(key(from(h), from(kernel::next_half(h))));
  }
  const auto join = [&](Index h, Index g) {
    twin[h] = g;
    if (g != kNone) twin[g] = h;
  };
  for (std::size_t i = 0; i < flips; ++i) {
    const auto h = static_cast<Index>(random() % sides);
    const Index g = twin[h];
    if (g == kNone) continue;
    // Faces (a, b, c) and (b, a, d) become (c, d, b) and (d, c, a).
    const Index bc = kernel::next_half(h), ca = kernel::previous_half(h);
    const Index ad = kernel::next_half(g), db = kernel::previous_half(g);
    const Index a = from(h), b = from(bc), c = from(ca), d = from(db);
    if (c == d || edges.count(key(c, d)) > 0) continue;
    edges.erase(key(a, b));
    edges.insert(key(c, d));
    const std::array<Index, 4> outer = {twin[db], twin[bc], twin[ca], twin[ad]};
    const Index f = h / 3, e = g / 3;
    faces[f] = {c, d, b};
    faces[e] = {d, c, a};
    join(3 * f, 3 * e);
    join(3 * f + 1, outer[0]);
    join(3 * f + 2, outer[1]);
    join(3 * e + 1, outer[2]);
    join(3 * e + 2, outer[3]);
  }
}

}  // namespace crest::sampling
