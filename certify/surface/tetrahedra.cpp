// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/surface/tetrahedra.hpp"

#include <algorithm>
#include <tuple>

#include "certify/container/reject.hpp"

namespace crest::certify {

/// Buckets by the least corner, then by the others.
std::vector<TetFace> list_faces(const std::vector<std::array<std::uint32_t, 4>>& tets,
                                std::size_t vertices) {
  struct Entry {
    std::uint32_t b, c, tet;
  };
  std::vector<std::size_t> start(vertices + 1, 0);
  for (const auto& t : tets) start[t[0] + 1] += 3, start[t[1] + 1] += 1;
  for (std::size_t v = 0; v < vertices; ++v) start[v + 1] += start[v];
  std::vector<Entry> entries(4 * tets.size());
  auto next = start;
  for (std::uint32_t i = 0; i < tets.size(); ++i) {
    const auto& t = tets[i];
    entries[next[t[0]]++] = {t[1], t[2], i};
    entries[next[t[0]]++] = {t[1], t[3], i};
    entries[next[t[0]]++] = {t[2], t[3], i};
    entries[next[t[1]]++] = {t[2], t[3], i};
  }
  std::vector<TetFace> faces;
  faces.reserve(2 * tets.size() + 2);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto from = entries.begin() + static_cast<std::ptrdiff_t>(start[v]);
    const auto to = entries.begin() + static_cast<std::ptrdiff_t>(start[v + 1]);
    std::sort(from, to, [](const Entry& x, const Entry& y) {
      return std::tie(x.b, x.c, x.tet) < std::tie(y.b, y.c, y.tet);
    });
    for (auto at = from; at != to; ++at) {
      if (at != from && at[-1].b == at->b && at[-1].c == at->c) {
        require(faces.back().tets[1] == kNoTet,
                "data: more than two tetrahedra at face ({}, {}, {})", v, at->b, at->c);
        require(tets[faces.back().tets[0]] != tets[at->tet],
                "data: tetrahedra {} and {} have the same corners", faces.back().tets[0], at->tet);
        faces.back().tets[1] = at->tet;
      } else {
        faces.push_back({{v, at->b, at->c}, {at->tet, kNoTet}});
      }
    }
  }
  return faces;
}

std::uint32_t find_face(const std::vector<TetFace>& faces,
                        const std::array<std::uint32_t, 3>& corners) {
  const auto at = std::ranges::lower_bound(faces, corners, {}, &TetFace::corners);
  return at != faces.end() && at->corners == corners
             ? static_cast<std::uint32_t>(at - faces.begin())
             : kNoTet;
}

}  // namespace crest::certify
