// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/surface/gluing.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

void check_indices(Faces faces, std::size_t vertices) {
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const auto& [a, b, c] = faces[t];
    require(a < vertices && b < vertices && c < vertices, "face {}: no such vertex", t);
    require(a != b && b != c && c != a, "face {}: a vertex twice", t);
  }
}

struct Side {
  u32 high, corner;
};

/// By the larger vertex. Buckets are short as a rule: a call of std::sort costs more than the
/// sorting.
void sort_bucket(Side* begin, Side* end) {
  if (end - begin > 24)
    return std::sort(begin, end, [](const Side& s, const Side& t) { return s.high < t.high; });
  for (Side* at = begin; at < end; ++at) {
    const Side side = *at;
    Side* to = at;
    for (; to > begin && (to - 1)->high > side.high; --to) *to = *(to - 1);
    *to = side;
  }
}

/// Sides in buckets by their smaller vertex, each bucket by the larger one.
Buffer<Side> sorted_sides(Faces faces, Buffer<u32>& start) {
  for (const auto& t : faces)
    for (std::size_t i = 0; i < 3; ++i) ++start[std::min(t[i], t[i == 2 ? 0 : i + 1]) + 1];
  for (std::size_t v = 0; v + 1 < start.size(); ++v) start[v + 1] += start[v];
  Buffer<Side> sides(3 * faces.size());
  Buffer<u32> fill(start.begin(), start.end() - 1);
  u32 corner = 0;
  for (const auto& t : faces)
    for (std::size_t i = 0; i < 3; ++i, ++corner) {
      const u32 a = t[i], b = t[i == 2 ? 0 : i + 1];
      sides[fill[std::min(a, b)]++] = {std::max(a, b), corner};
    }
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    sort_bucket(sides.data() + start[v], sides.data() + start[v + 1]);
  return sides;
}

}  // namespace

Gluing glue(Faces faces, std::size_t vertices, bool with_edges) {
  check_indices(faces, vertices);
  Buffer<u32> start(vertices + 1, 0);
  const Buffer<Side> sides = sorted_sides(faces, start);
  Gluing g;
  g.twin.assign(sides.size(), kNone);
  if (with_edges) {
    g.edge_of.resize(sides.size());
    g.edges.reserve(sides.size() / 2 + 16);
  }
  for (u32 low = 0; low < vertices; ++low)
    for (u32 i = start[low]; i < start[low + 1]; ++g.edge_count) {
      const u32 high = sides[i].high, a = sides[i].corner;
      u32 end = i + 1;
      while (end < start[low + 1] && sides[end].high == high) ++end;
      require(end - i <= 2, "edge {} {}: in more than two faces", low, high);
      if (end - i == 2) {
        const u32 b = sides[i + 1].corner;
        g.twin[a] = b;
        g.twin[b] = a;
        g.aligned = g.aligned && vertex_of(faces, a) != vertex_of(faces, b);
        // Two faces with the same corners share each of their sides.
        require(vertex_of(faces, previous_corner(a)) != vertex_of(faces, previous_corner(b)),
                "faces {} and {}: the same corners", a / 3, b / 3);
      }
      if (with_edges) {
        g.edges.push_back({low, high});
        for (; i < end; ++i) g.edge_of[sides[i].corner] = static_cast<u32>(g.edge_count);
      }
      i = end;
    }
  return g;
}

}  // namespace crest::certify
