// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/vertex_stars.hpp"

#include <algorithm>
#include <utility>

namespace crest::reeb {

VertexStars::VertexStars(std::span<const Triangle> triangles, Index vertex_count)
    : begin_(vertex_count + std::size_t{1}, 0), sides_(3 * triangles.size()) {
  for (const Triangle& t : triangles)
    for (const Index v : t) ++begin_[v];
  Index sum = 0;
  for (Index& b : begin_) sum += std::exchange(b, sum);
  // begin_[v] runs through the star of v, then all are moved back by one star.
  for (const Triangle& t : triangles) {
    sides_[begin_[t[0]]++] = {t[1], t[2]};
    sides_[begin_[t[1]]++] = {t[2], t[0]};
    sides_[begin_[t[2]]++] = {t[0], t[1]};
  }
  for (std::size_t v = vertex_count; v > 0; --v) begin_[v] = begin_[v - 1];
  begin_[0] = 0;
  find_disagreements();
}

/// Coherent: in no star do two sides start at the same vertex. (Then every walk along a link
/// enters all sides at their starts, or all at their ends, so none disagrees with the first.)
void VertexStars::find_disagreements() {
  const auto count = static_cast<Index>(begin_.size() - 1);
  std::vector<Index> seen(count, kNone);
  bool coherent = true;
  for (Index v = 0; v < count && coherent; ++v) {
    for (const Side& s : star(v)) {
      coherent = coherent && seen[s[0]] != v;
      seen[s[0]] = v;
    }
  }
  if (coherent) return;
  disagrees_.assign(sides_.size(), 0);
  Link link_of_v;
  for (Index v = 0; v < count; ++v) {
    link(v, link_of_v);
    const auto& ring = link_of_v.vertices;
    for (std::size_t i = 0; i < ring.size(); ++i) seen[ring[i]] = static_cast<Index>(i);
    for (Index i = begin_[v]; i < begin_[v + 1]; ++i) {
      const Index a = seen[sides_[i][0]], b = seen[sides_[i][1]];
      const bool along = b == a + 1 || (link_of_v.closed && b == 0 && a + 1 == ring.size());
      disagrees_[i] = along ? 0 : 1;
    }
  }
}

bool VertexStars::flips_in_some_triangle(Index v, Index w) const {
  for (Index i = begin_[v]; i < begin_[v + 1]; ++i) {
    if (sides_[i][0] != w && sides_[i][1] != w) continue;
    const Index apex = sides_[i][0] == w ? sides_[i][1] : sides_[i][0];
    for (Index j = begin_[w]; j < begin_[w + 1]; ++j) {
      const bool same = (sides_[j][0] == v && sides_[j][1] == apex) ||
                        (sides_[j][1] == v && sides_[j][0] == apex);
      if (same) return disagrees_[i] != disagrees_[j];
    }
  }
  return false;
}

void VertexStars::fill_slots(std::span<const Side> star) {
  if (slots_.empty()) slots_.assign(begin_.size() - 1, {kNone, kNone});
  for (const Side& s : star)
    for (const Index x : s) slots_[x] = {kNone, kNone};
  for (Index i = 0; i < star.size(); ++i)
    for (const Index x : star[i]) slots_[x][slots_[x][0] == kNone ? 0 : 1] = i;
}

/// The side of the star that meets the given one at this vertex, or kNone.
Index VertexStars::other_side(std::span<const Side> star, Index side, Index vertex) const {
  if (star.size() > kSmall) return slots_[vertex][slots_[vertex][0] == side ? 1 : 0];
  for (Index j = 0; j < star.size(); ++j)
    if (j != side && (star[j][0] == vertex || star[j][1] == vertex)) return j;
  return kNone;
}

/// Appends the vertices met when going on over `from`, a vertex of side 0.
void VertexStars::walk(std::span<const Side> star, Index from, Link& out) {
  Index side = 0, x = from;
  out.vertices.push_back(x);
  for (;;) {
    side = other_side(star, side, x);
    if (side == kNone) return;
    if (side == 0) {
      out.closed = true;
      return;
    }
    x = star[side][0] == x ? star[side][1] : star[side][0];
    out.vertices.push_back(x);
  }
}

void VertexStars::link(Index v, Link& out) {
  const std::span<const Side> sides = star(v);
  if (sides.size() > kSmall) fill_slots(sides);
  out.vertices.clear();
  out.closed = false;
  walk(sides, sides[0][0], out);  // against the direction
  std::reverse(out.vertices.begin(), out.vertices.end());
  if (out.closed) {
    // The walk ended at the other vertex of side 0: it starts the reversed list, as it must.
    return;
  }
  walk(sides, sides[0][1], out);
}

}  // namespace crest::reeb
