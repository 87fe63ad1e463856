// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"

namespace crest::certify::reeb {
namespace {

void check_records(const ReebContents& c) {
  const std::size_t n = c.critical_nodes.size();
  const auto below = [](const ArcRecord& a, const ArcRecord& b) {
    return a.lower != b.lower ? a.lower < b.lower : a.upper < b.upper;
  };
  for (std::size_t i = 0; i < c.arcs.size(); ++i) {
    const ArcRecord& a = c.arcs[i];
    require(a.upper < n, "arc {}: no critical node {}", i, a.upper);
    require(a.lower < a.upper, "arc {}: its lower end is not below its upper end", i);
    require(i == 0 || !below(a, c.arcs[i - 1]), "arc {}: out of order", i);
  }
  for (std::size_t i = 0; i < c.cuts.size(); ++i) {
    require(c.cuts[i].arc < c.arcs.size(), "cut {}: no arc {}", i, c.cuts[i].arc);
    require(c.cuts[i].node < c.order.size(), "cut {}: no node {}", i, c.cuts[i].node);
    require(i == 0 || c.cuts[i - 1].arc < c.cuts[i].arc, "cut {}: out of order", i);
  }
}

/// A contour is known by its node v and its least w.
void check_distinct(const ReebContents& c) {
  std::vector<std::array<u32, 2>> contours;
  contours.reserve(c.cuts.size());
  for (const CutRecord& cut : c.cuts) contours.push_back({c.arcs[cut.arc].lower, cut.node});
  std::sort(contours.begin(), contours.end());
  require(std::adjacent_find(contours.begin(), contours.end()) == contours.end(),
          "cuts: one contour twice");
}

bool has(const Corners& tile, u32 node) {
  return tile[0] == node || tile[1] == node || tile[2] == node;
}

struct Place {
  u32 face, tile;
};
constexpr Place kNowhere{kNone, kNone};

/// The tile of the face with the edge a b, other than `not_this`.
Place find_in_face(const Complex& k, u32 face, u32 a, u32 b, u32 not_this) {
  const u32 first = k.divided() ? k.tiling.first[face] : face;
  const u32 end = k.divided() ? k.tiling.first[face + 1] : face + 1;
  for (u32 t = first; t < end; ++t)
    if (t != not_this && has(k.tiles()[t], a) && has(k.tiles()[t], b)) return {face, t};
  return kNowhere;
}

/// Calls visit(face) for the faces around a vertex of the mesh: first one way round, then, if that
/// ends at the boundary, the other.
template <class Visit>
void for_faces_around(const Complex& k, u32 v, const Visit& visit) {
  const u32 corner = k.surface.corner[v];
  for (const bool way : {false, true}) {
    bool by_previous = way;
    u32 c = corner;
    do {
      if (!way || c != corner) visit(c / 3);
      const u32 across = k.mesh.twin[by_previous ? previous_corner(c) : c];
      if (across == kNone) break;
      by_previous = vertex_of(k.faces, across) == v;
      c = by_previous ? across : next_corner(across);
    } while (c != corner);
    if (k.mesh.twin[by_previous ? previous_corner(c) : c] != kNone) return;
  }
}

/// A tile with a given edge. Edges are asked for by ascending lower node: a search around a node
/// serves all of its edges, so that a node of many cuts costs no more than its degree.
class EdgeFinder {
 public:
  explicit EdgeFinder(const Complex& k) : k_(k), side_of_(k.divided() ? k.mesh.edges.size() : 0) {
    for (u32 side = 0; k.divided() && side < k.mesh.edge_of.size(); ++side)
      side_of_[k.mesh.edge_of[side]] = side;
  }
  /// With the edge v w; kNowhere if there is none.
  Place find(u32 v, u32 w) {
    if (v != v_) collect(v);
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), w,
                                     [](const Edge& e, u32 to) { return e.node < to; });
    return at != edges_.end() && at->node == w ? at->place : kNowhere;
  }

 private:
  struct Edge {
    u32 node;
    Place place;
  };

  void collect(u32 v) {
    v_ = v;
    edges_.clear();
    const auto vertices = static_cast<u32>(k_.surface.corner.size());
    const auto lines = static_cast<u32>(k_.tiling.line_edges.size());
    if (v < vertices) {
      for_faces_around(k_, v, [&](u32 face) { add(face); });
    } else if (v < vertices + lines) {
      const u32 side = side_of_[k_.tiling.line_edges[v - vertices]], twin = k_.mesh.twin[side];
      add(side / 3);
      if (twin != kNone) add(twin / 3);
    } else {
      add(k_.tiling.critical_faces[v - vertices - lines]);
    }
    std::sort(edges_.begin(), edges_.end(),
              [](const Edge& a, const Edge& b) { return a.node < b.node; });
  }
  void add(u32 face) {
    const u32 first = k_.divided() ? k_.tiling.first[face] : face;
    const u32 end = k_.divided() ? k_.tiling.first[face + 1] : face + 1;
    for (u32 t = first; t < end; ++t)
      if (has(k_.tiles()[t], v_))
        for (const u32 node : k_.tiles()[t])
          if (node != v_) edges_.push_back({node, {face, t}});
  }

  const Complex& k_;
  Buffer<u32> side_of_;  ///< E, if the faces are divided
  u32 v_ = kNone;
  std::vector<Edge> edges_;  ///< at v_
};

/// The other tile at the edge a b of `from`: in the same face, or beyond the side of the face that
/// holds both nodes, as no face has an edge between nodes of one side inside.
Place beyond(const Complex& k, Place from, u32 a, u32 b) {
  if (!k.divided()) {
    const Corners& face = k.faces[from.face];
    const u32 i = face[0] != a && face[0] != b ? 1 : face[1] != a && face[1] != b ? 2 : 0;
    const u32 twin = k.mesh.twin[3 * from.face + i];
    return twin == kNone ? kNowhere : Place{twin / 3, twin / 3};
  }
  if (const Place in = find_in_face(k, from.face, a, b, from.tile); in.face != kNone) return in;
  for (u32 side = 3 * from.face; side < 3 * from.face + 3; ++side) {
    const u32 p = vertex_of(k.faces, side), q = vertex_of(k.faces, next_corner(side));
    const u32 r = k.line_node(side);
    if ((a != p && a != q && a != r) || (b != p && b != q && b != r)) continue;
    const u32 twin = k.mesh.twin[side];
    return twin == kNone ? kNowhere : find_in_face(k, twin / 3, a, b, kNone);
  }
  return kNowhere;
}

struct Crossed {
  u32 low, high, cut;
};
/// Contours can be as long as the mesh is large, and there can be as many: without a bound, time
/// and memory could be quadratic.
constexpr std::size_t most_crossings(std::size_t nodes) {
  return std::max(std::size_t{1} << 22, 64 * nodes);
}

/// Walks one contour at the level just above a node v.
class Walk {
 public:
  Walk(const Complex& k, u32 cut, u32 v, std::vector<Crossed>& out)
      : k_(k), cut_(cut), v_(v), level_(k.rank[v]), out_(out) {}

  /// From the edge v w. Returns whether the contour is a cycle.
  bool run(Place start, u32 w) {
    w_ = w;
    record(v_, w);
    if (follow(start)) return true;
    const Place other = beyond(k_, start, v_, w);
    if (other.face != kNone) follow(other);
    return false;
  }
  u32 least() const { return least_; }

 private:
  void record(u32 low, u32 high) {
    require(out_.size() < most_crossings(k_.nodes()), "cuts: they cross more than {} edges",
            most_crossings(k_.nodes()));
    out_.push_back({low, high, cut_});
    if (low == v_) least_ = std::min(least_, high);
  }
  /// Into the tile and on; true when back at the start, false at the boundary. A tile has two
  /// crossed edges and an edge two tiles at most, so the walk cannot enter a cycle elsewhere.
  bool follow(Place at) {
    for (u32 low = v_, high = w_; at.face != kNone; at = beyond(k_, at, low, high)) {
      u32 third = kNone;
      for (const u32 node : k_.tiles()[at.tile])
        if (node != low && node != high) third = node;
      (k_.rank[third] <= level_ ? low : high) = third;
      if (low == v_ && high == w_) return true;
      record(low, high);
    }
    return false;
  }

  const Complex& k_;
  u32 cut_, v_, level_, w_ = kNone, least_ = kNone;
  std::vector<Crossed>& out_;
};

bool walk_cut(const ReebContents& c, const Complex& k, u32 cut, EdgeFinder& edges,
              std::vector<Crossed>& out) {
  const u32 v = c.critical_nodes[c.arcs[c.cuts[cut].arc].lower], w = c.cuts[cut].node;
  require(k.rank[w] > k.rank[v], "cut {}: node {} is not above node {}", cut, w, v);
  const Place start = edges.find(v, w);
  require(start.face != kNone, "cut {}: no edge from node {} to {}", cut, v, w);
  Walk walk(k, cut, v, out);
  const bool cycle = walk.run(start, w);
  require(walk.least() == w, "cut {}: the contour crosses the edge to node {} also", cut,
          walk.least());
  return cycle;
}

/// Cuts ascend by arc, arcs by lower end: along an edge the later cut is higher. Two at one level
/// are different contours and share no edge.
void sort_crossings(const std::vector<Crossed>& crossed, std::size_t nodes, Cuts& out) {
  out.start.assign(nodes + 2, 0);
  for (const Crossed& x : crossed) ++out.start[x.low + 2];
  for (std::size_t v = 2; v < out.start.size(); ++v) out.start[v] += out.start[v - 1];
  out.crossings.resize(crossed.size());
  for (const Crossed& x : crossed) out.crossings[out.start[x.low + 1]++] = {x.high, x.cut};
  out.start.pop_back();
  // Short as a rule: a call of std::sort costs more than the sorting.
  const auto after = [](const Cuts::Crossing& a, const Cuts::Crossing& b) {
    return a.high != b.high ? a.high > b.high : a.cut > b.cut;
  };
  for (std::size_t v = 0; v < nodes; ++v) {
    const auto first = out.crossings.begin() + out.start[v];
    const auto last = out.crossings.begin() + out.start[v + 1];
    if (last - first > 24)
      std::sort(first, last, [&](const auto& a, const auto& b) { return after(b, a); });
    else
      for (auto at = first; at < last; ++at)
        for (auto to = at; to > first && after(*(to - 1), *to); --to) std::swap(*(to - 1), *to);
  }
}

}  // namespace

Cuts check_cuts(const ReebContents& c, const Complex& k) {
  check_records(c);
  check_distinct(c);
  Cuts out;
  if (c.cuts.empty()) return out;
  std::vector<Crossed> crossed;
  out.cycle.reserve(c.cuts.size());
  EdgeFinder edges(k);
  for (u32 cut = 0; cut < c.cuts.size(); ++cut)
    out.cycle.push_back(walk_cut(c, k, cut, edges, crossed));
  sort_crossings(crossed, k.nodes(), out);
  return out;
}

std::span<const Cuts::Crossing> Cuts::across(u32 low, u32 high) const {
  if (!near(low)) return {};
  const Crossing* first = crossings.data() + start[low];
  const Crossing* const last = crossings.data() + start[low + 1];
  if (last - first <= 16) {
    while (first < last && first->high != high) ++first;
    const Crossing* end = first;
    while (end < last && end->high == high) ++end;
    return {first, end};
  }
  const auto* const begin = std::lower_bound(
      first, last, high, [](const Crossing& crossing, u32 to) { return crossing.high < to; });
  const auto* const end = std::upper_bound(
      begin, last, high, [](u32 to, const Crossing& crossing) { return to < crossing.high; });
  return {begin, end};
}

}  // namespace crest::certify::reeb
