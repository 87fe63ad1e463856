// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/cell_topology.hpp"

#include <unordered_map>

namespace crest::modes {

std::optional<std::size_t> piece_count(std::size_t loops, std::size_t above, std::size_t below) {
  if (loops == 0) return above + below == 1 ? std::optional<std::size_t>(0) : std::nullopt;
  if (above + below < 2) return std::nullopt;
  const std::size_t count = above + below - 1;
  if (count == loops || count == 1) return count;
  return std::nullopt;
}

CellTopology::CellTopology(Faces& faces, const std::array<Index, 4>& facets,
                           const std::array<std::int16_t, 4>& w)
    : faces_(faces), w_(w) {
  for (std::size_t i = 0; i < 4; ++i) faces_.leaves(facets[i], leaves_[i]);
}

bool CellTopology::make_loops(Side side, std::vector<Loop>& loops) const {
  struct Ends {
    Index arc[2] = {kNone, kNone};
  };
  std::unordered_map<Index, Ends> at;
  std::vector<Index> arcs;
  for (const auto& leaves : leaves_)
    for (const Index f : leaves) {
      const Face& face = faces_.face(f);
      for (Index k = 0; k < face.arc_count; ++k) {
        const Index a = face.first_arc + k;
        const Arc& arc = faces_.arcs()[a];
        if (arc.side != side) continue;
        arcs.push_back(a);
        for (const Index r : arc.roots) {
          Ends& ends = at[r];
          if (ends.arc[1] != kNone) return false;
          ends.arc[ends.arc[0] == kNone ? 0 : 1] = a;
        }
      }
    }
  for (const auto& [root, ends] : at)
    if (ends.arc[1] == kNone) return false;
  std::unordered_map<Index, bool> used;
  for (const Index first : arcs) {
    if (used[first]) continue;
    Loop& loop = loops.emplace_back();
    Index a = first, root = faces_.arcs()[a].roots[0];
    while (!used[a]) {
      used[a] = true;
      const Arc& arc = faces_.arcs()[a];
      const bool forward = arc.roots[0] == root;
      loop.push_back({a, forward});
      root = arc.roots[forward ? 1 : 0];
      const Ends& ends = at[root];
      a = ends.arc[0] == a ? ends.arc[1] : ends.arc[0];
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
    const auto& list = faces_.lines().roots(edge.line);
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
      for (const Index f : leaves_[i]) add_face(side, f);
  std::size_t count = 0;
  for (Index i = 0; i < intervals_.size(); ++i)
    if (find(i) == i && intervals_[i].above == above) ++count;
  return count;
}

std::optional<std::vector<Piece>> CellTopology::pieces(Side side) {
  std::vector<Loop> loops;
  if (!make_loops(side, loops)) return std::nullopt;
  // w leaves the cell through facets with w_i < 0.
  const auto count =
      piece_count(loops.size(), components(side, -1, true), components(side, 1, false));
  if (!count) return std::nullopt;
  std::vector<Piece> pieces;
  if (*count == loops.size())
    for (Loop& loop : loops) pieces.push_back({std::move(loop)});
  else
    pieces.push_back(std::move(loops));
  return pieces;
}

}  // namespace crest::modes
