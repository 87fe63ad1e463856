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

/// A half-edge with the other two corners of its face.
struct Leaving {
  Index half, end, third;
};

/// Half-edges by the vertex they start at: those of v end at end[v].
struct Buckets {
  std::vector<Index> end;
  std::vector<Leaving> list;
};

Buckets by_start(Index vertices, std::span<const Triangle> faces) {
  Buckets b;
  // One place further: filling moves each beginning to its end.
  b.end.assign(std::size_t{vertices} + 1, 0);
  for (const Triangle& t : faces)
    for (const Index v : t) ++b.end[v + 1];
  std::partial_sum(b.end.begin(), b.end.end(), b.end.begin());
  b.list.resize(3 * faces.size());
  Index h = 0;
  for (const auto& [p, q, r] : faces) {
    b.list[b.end[p]++] = {h, q, r};
    b.list[b.end[q]++] = {h + 1, r, p};
    b.list[b.end[r]++] = {h + 2, p, q};
    h += 3;
  }
  return b;
}

/// Faces from the one at h on counter-clockwise, to the boundary or back; `most` at most: each fan
/// of several would end early.
std::size_t fan_size(const std::vector<Index>& opposite, Index first, std::size_t most) {
  std::size_t seen = 0;
  Index h = first;
  do {
    ++seen;
    h = opposite[previous_half(h)];
  } while (h != kNone && h != first && seen < most);
  return seen;
}

}  // namespace

CornerTable::CornerTable(Index vertices, std::span<const Triangle> faces) {
  if (faces.empty()) throw InputError("mesh: it has no faces; give a triangle mesh");
  for (Index f = 0; f < faces.size(); ++f) require_three_vertices(f, faces[f], vertices);
  const Buckets starts = by_start(vertices, faces);
  opposite_.assign(3 * faces.size(), kNone);
  half_of_.assign(vertices, kNone);
  // The last half-edge v -> w, at w, for the v at hand.
  struct Last {
    Index v, half, third;
  };
  std::vector<Last> to(vertices, Last{kNone, kNone, kNone});
  Index broken = kNone;
  for (Index v = 0; v < vertices; ++v) {
    const Index begin = v == 0 ? 0 : starts.end[v - 1];
    const std::span<const Leaving> out{starts.list.data() + begin, starts.end[v] - begin};
    for (const auto& [h, w, third] : out) {
      if (to[w].v == v) refuse_pair(faces, to[w].half / 3, h / 3, v, w);
      to[w] = {v, h, third};
    }
    // w -> v with w in a face of v: the half-edge before one that starts at v.
    for (const auto& [h, third, w] : out) {
      const Last& back = to[w];
      if (back.v != v) continue;
      const Index in = previous_half(h);
      opposite_[in] = back.half;
      opposite_[back.half] = in;
      if (third == back.third) refuse_pair(faces, in / 3, back.half / 3, v, w);
    }
    // All that starts or ends at v is paired now.
    for (const Leaving& leaving : out)
      if (half_of_[v] == kNone || opposite_[leaving.half] == kNone) half_of_[v] = leaving.half;
    if (out.empty() || fan_size(opposite_, half_of_[v], out.size()) != out.size())
      broken = std::min(broken, v);
  }
  if (broken == kNone) return;
  throw InputError(name("vertex", broken) +
                   (half_of_[broken] == kNone ? ": it belongs to no face; remove isolated vertices"
                                              : ": several fans of faces meet in it; split it"));
}

}  // namespace crest::kernel
