// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/corner_table.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/geometry/mesh_checks.hpp"

namespace crest::kernel {
namespace {

[[noreturn]] void refuse_pair(std::span<const Triangle> faces, Index f, Index g, Index v, Index w) {
  if (same_corners(faces[f], faces[g]))
    throw InputError(name("face", std::max(f, g)) + ": it duplicates face " +
                     std::to_string(std::min(f, g)) + "; remove duplicate faces");
  throw InputError(edge_name(std::min(v, w), std::max(v, w)) +
                   ": two of its faces are oriented inconsistently, or it has more than two; make "
                   "the mesh manifold and orient it");
}

/// Half-edges by the vertex they start at.
struct Buckets {
  std::vector<Index> begin, halves;
};

Buckets by_start(Index vertices, std::span<const Triangle> faces) {
  Buckets b;
  b.begin.assign(vertices + 1, 0);
  for (const Triangle& t : faces)
    for (const Index v : t) ++b.begin[v + 1];
  std::partial_sum(b.begin.begin(), b.begin.end(), b.begin.begin());
  b.halves.resize(3 * faces.size());
  std::vector<Index> next(b.begin.begin(), b.begin.end() - 1);
  for (Index h = 0; h < b.halves.size(); ++h) b.halves[next[faces[h / 3][h % 3]]++] = h;
  return b;
}

}  // namespace

CornerTable::CornerTable(Index vertices, std::span<const Triangle> faces) {
  if (faces.empty()) throw InputError("mesh: it has no faces; give a triangle mesh");
  for (Index f = 0; f < faces.size(); ++f) require_three_vertices(f, faces[f], vertices);
  const Buckets starts = by_start(vertices, faces);
  const auto end_of = [&](Index h) { return faces[h / 3][(h % 3 + 1) % 3]; };
  opposite_.assign(3 * faces.size(), kNone);
  half_of_.assign(vertices, kNone);
  // Where the last half-edge v -> w stands, for the v at hand.
  std::vector<Index> to(vertices, kNone);
  for (Index v = 0; v < vertices; ++v) {
    const std::span<const Index> out{starts.halves.data() + starts.begin[v],
                                     starts.halves.data() + starts.begin[v + 1]};
    for (const Index h : out) {
      Index& seen = to[end_of(h)];
      if (seen != kNone && faces[seen / 3][seen % 3] == v)
        refuse_pair(faces, seen / 3, h / 3, v, end_of(h));
      seen = h;
    }
    // w -> v with w in a face of v: the half-edge after next of one that starts at v.
    for (const Index h : out) {
      const Index in = previous_half(h), w = faces[in / 3][in % 3], back = to[w];
      if (back == kNone || faces[back / 3][back % 3] != v) continue;
      opposite_[in] = back;
      if (same_corners(faces[in / 3], faces[back / 3])) refuse_pair(faces, in / 3, back / 3, v, w);
    }
  }
  for (Index v = 0; v < vertices; ++v) {
    const std::span<const Index> out{starts.halves.data() + starts.begin[v],
                                     starts.halves.data() + starts.begin[v + 1]};
    if (out.empty())
      throw InputError(name("vertex", v) + ": it belongs to no face; remove isolated vertices");
    half_of_[v] = out.front();
    for (const Index h : out)
      if (opposite_[h] == kNone) half_of_[v] = h;
    // Counter-clockwise from the boundary, if there is one: each fan of several would end early.
    std::size_t seen = 0;
    Index h = half_of_[v];
    do {
      ++seen;
      h = opposite_[previous_half(h)];
    } while (h != kNone && h != half_of_[v] && seen < out.size());
    if (seen != out.size())
      throw InputError(name("vertex", v) + ": several fans of faces meet in it; split it");
  }
}

}  // namespace crest::kernel
