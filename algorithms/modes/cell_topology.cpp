// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/cell_topology.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>

namespace crest::modes {

std::optional<std::size_t> piece_count(std::size_t loops, std::size_t above, std::size_t below) {
  if (loops == 0) return above + below == 1 ? std::optional<std::size_t>(0) : std::nullopt;
  if (above + below < 2) return std::nullopt;
  const std::size_t count = above + below - 1;
  if (count == loops || count == 1) return count;
  return std::nullopt;
}

template <class Start, class Add>
bool CellTopology::trace(Side side, Start&& start, Add&& add) const {
  struct End {
    Index root;
    std::uint32_t arc;  ///< its place in the list
    std::uint8_t which;
  };
  struct Link {
    Index arc;
    std::array<std::uint32_t, 2> next;  ///< beyond its first root, its second
    bool used;
  };
  boost::container::small_vector<Link, 16> arcs;
  boost::container::small_vector<End, 32> ends;
  for (const Index facet : facets_)
    faces_.for_each_arc(facet, side, [&](Index a) {
      const auto place = static_cast<std::uint32_t>(arcs.size());
      arcs.push_back({a, {}, false});
      for (std::uint8_t k = 0; k < 2; ++k) ends.push_back({faces_.arcs()[a].roots[k], place, k});
    });
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return a.root != b.root ? a.root < b.root : a.arc < b.arc;
  });
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    if (i + 1 == ends.size() || ends[i].root != ends[i + 1].root ||
        (i + 2 < ends.size() && ends[i].root == ends[i + 2].root))
      return false;
    arcs[ends[i].arc].next[ends[i].which] = ends[i + 1].arc;
    arcs[ends[i + 1].arc].next[ends[i + 1].which] = ends[i].arc;
  }
  for (std::uint32_t first = 0; first < arcs.size(); ++first) {
    if (arcs[first].used) continue;
    start();
    Index root = faces_.arcs()[arcs[first].arc].roots[0];
    for (std::uint32_t i = first; !arcs[i].used;) {
      Link& link = arcs[i];
      link.used = true;
      const auto& roots = faces_.arcs()[link.arc].roots;
      const bool forward = roots[0] == root;
      add(LoopArc{link.arc, forward});
      root = roots[forward ? 1 : 0];
      i = link.next[forward ? 1 : 0];
    }
  }
  return true;
}

Index CellTopology::interval(Side side, Index line, std::size_t number) {
  for (Index i = 0; i < intervals_.size(); ++i)
    if (intervals_[i].line == line && intervals_[i].number == number) return i;
  const auto i = static_cast<Index>(intervals_.size());
  const bool start = is_above(faces_.vertices().signs(faces_.lines().line(line).a), side);
  intervals_.push_back({line, number, i, start == (number % 2 == 0)});
  return i;
}

Index CellTopology::find(Index i) {
  while (intervals_[i].parent != i)
    i = intervals_[i].parent = intervals_[intervals_[i].parent].parent;
  return i;
}

void CellTopology::unite(Index a, Index b) {
  intervals_[find(a)].parent = find(b);
}

void CellTopology::add_face(Side side, Index f) {
  const Face face = faces_.face(f);
  // Intervals around the face; between the i-th and the next lies a root, or a corner.
  std::vector<Index> around;
  std::vector<std::size_t> before;  // of root k of the side: the interval that it ends
  std::vector<Index> root_number;   // its number among all roots around the face
  Index number = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge& edge = faces_.edge(face.edges[k]);
    const RootRange range = faces_.roots(face.edges[k]);
    const RootNumbers list = faces_.lines().roots(edge.line);
    std::size_t start = 0, inside = 0;
    for (std::size_t i = 0; i < range.first + range.count; ++i)
      if (faces_.lines().root(list[i]).side == side) ++(i < range.first ? start : inside);
    const bool forward = edge.first == face.corners[k];
    const auto id = [&](std::size_t i) {
      return interval(side, edge.line, start + (forward ? i : inside - i));
    };
    const Index first = id(0);
    if (!around.empty()) unite(around.back(), first);
    around.push_back(first);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < range.count; ++i) {
      const std::size_t at = range.first + (forward ? i : range.count - 1 - i);
      if (faces_.lines().root(list[at]).side == side) {
        before.push_back(around.size() - 1);
        root_number.push_back(number);
        around.push_back(id(++seen));
      }
      ++number;
    }
  }
  unite(around.back(), around.front());
  for (Index k = 0; k < face.arc_count; ++k) {
    const Arc& arc = faces_.arcs()[face.first_arc + k];
    if (arc.side != side) continue;
    std::size_t at[2] = {0, 0};
    for (std::size_t r = 0; r < root_number.size(); ++r)
      for (std::size_t e = 0; e < 2; ++e)
        if (root_number[r] == arc.numbers[e]) at[e] = before[r];
    unite(around[at[0]], around[at[1] + 1]);
    unite(around[at[0] + 1], around[at[1]]);
  }
}

std::size_t CellTopology::components(Side side, int sign, bool above) {
  intervals_.clear();
  for (std::size_t i = 0; i < 4; ++i)
    if ((w_[i] > 0) - (w_[i] < 0) == sign)
      faces_.for_each_leaf(facets_[i], [&](Index f) { add_face(side, f); });
  std::size_t count = 0;
  for (Index i = 0; i < intervals_.size(); ++i)
    if (find(i) == i && intervals_[i].above == above) ++count;
  return count;
}

std::optional<std::size_t> CellTopology::loop_count(Side side) const {
  std::size_t loops = 0;
  const bool closed = trace(
      side, [&] { ++loops; }, [](const LoopArc&) {});
  return closed ? std::optional(loops) : std::nullopt;
}

std::optional<std::size_t> CellTopology::count_by_loops(Side side) const {
  const auto loops = loop_count(side);
  // One loop bounds a disk: every component has a loop.
  return loops && *loops <= 1 ? loops : std::nullopt;
}

std::optional<std::size_t> CellTopology::count(Side side) {
  const auto loops = loop_count(side);
  if (!loops || *loops <= 1) return loops;
  // w leaves the cell through facets with w_i < 0.
  return piece_count(*loops, components(side, -1, true), components(side, 1, false));
}

std::vector<Piece> CellTopology::pieces(Side side, std::size_t count) const {
  std::vector<Loop> loops;
  trace(
      side, [&] { loops.emplace_back(); }, [&](const LoopArc& a) { loops.back().push_back(a); });
  std::vector<Piece> pieces;
  if (count == loops.size())
    for (Loop& loop : loops) pieces.push_back({std::move(loop)});
  else
    pieces.push_back(std::move(loops));
  return pieces;
}

}  // namespace crest::modes
