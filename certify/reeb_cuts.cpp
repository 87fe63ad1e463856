// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/reeb_checks.hpp"
#include "certify/reject.hpp"

namespace crest::certify::reeb {
namespace {

using u32 = std::uint32_t;

bool by_edge_and_cut(const Cuts::Crossing& a, const Cuts::Crossing& b) {
  return a.edge != b.edge ? a.edge < b.edge : a.cut < b.cut;
}

void check_records(const ReebCertificate& c) {
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

/// The side from v, on which `side` ends, to w; kNone if there is none.
u32 find_side(const Complex& k, u32 side, u32 v, u32 w) {
  u32 found = kNone;
  for_corners_around(k, k.node(side) == v ? side : next_corner(side), [&](u32 corner) {
    if (k.node(next_corner(corner)) == w) found = corner;
    if (k.node(previous_corner(corner)) == w) found = previous_corner(corner);
    return found != kNone;
  });
  return found;
}

/// Walks one contour at the level just above a node.
class Walk {
 public:
  Walk(const Complex& k, u32 cut, u32 v, std::vector<Cuts::Crossing>& crossings)
      : k_(k), cut_(cut), v_(v), level_(k.rank[v]), crossings_(crossings) {}

  /// From the side v w. Returns whether the contour is a cycle.
  bool run(u32 side) {
    start_ = k_.edge(side);
    record(side);
    if (follow(side)) return true;
    if (k_.twin[side] != kNone) follow(k_.twin[side]);
    return false;
  }
  u32 least() const { return least_; }

 private:
  bool crosses(u32 side) const {
    const auto [low, high] = k_.ends(side);
    return k_.rank[low] <= level_ && k_.rank[high] > level_;
  }
  void record(u32 side) {
    crossings_.push_back({k_.edge(side), cut_});
    const auto [low, high] = k_.ends(side);
    if (low == v_) least_ = std::min(least_, high);
  }
  /// Into the tile of `side` and on; true when back at the start, false at the boundary. A tile has
  /// two crossed sides and an edge two tiles at most, so the walk cannot enter a cycle elsewhere.
  bool follow(u32 side) {
    while (true) {
      const u32 next = next_corner(side);
      side = crosses(next) ? next : next_corner(next);
      if (k_.edge(side) == start_) return true;
      record(side);
      side = k_.twin[side];
      if (side == kNone) return false;
    }
  }

  const Complex& k_;
  u32 cut_, v_, level_, start_ = 0, least_ = kNone;
  std::vector<Cuts::Crossing>& crossings_;
};

void walk_cut(const ReebCertificate& c, const Complex& k, const NodeTypes& types, u32 cut,
              Cuts& out) {
  const u32 v = c.critical_nodes[c.arcs[c.cuts[cut].arc].lower], w = c.cuts[cut].node;
  require(k.rank[w] > k.rank[v] && types.nodes[v].up != kNone,
          "cut {}: node {} is not above node {}", cut, w, v);
  const u32 side = find_side(k, types.nodes[v].up, v, w);
  require(side != kNone, "cut {}: no edge from node {} to {}", cut, v, w);
  out.side.push_back(side);
  Walk walk(k, cut, v, out.crossings);
  out.cycle.push_back(walk.run(side));
  require(walk.least() == w, "cut {}: the contour crosses the edge to node {} also", cut,
          walk.least());
}

/// A contour is known by its node v and its least w.
void check_distinct(const ReebCertificate& c) {
  std::vector<std::array<u32, 2>> contours;
  contours.reserve(c.cuts.size());
  for (const CutRecord& cut : c.cuts) contours.push_back({c.arcs[cut.arc].lower, cut.node});
  std::sort(contours.begin(), contours.end());
  require(std::adjacent_find(contours.begin(), contours.end()) == contours.end(),
          "cuts: one contour twice");
}

}  // namespace

Cuts check_cuts(const ReebCertificate& c, const Complex& k, const NodeTypes& types) {
  check_records(c);
  check_distinct(c);
  Cuts out;
  if (c.cuts.empty()) return out;
  for (u32 cut = 0; cut < c.cuts.size(); ++cut) walk_cut(c, k, types, cut, out);
  // Cuts ascend by arc, arcs by lower end: along an edge the later cut is higher. Two at one level
  // are different contours and share no edge.
  std::sort(out.crossings.begin(), out.crossings.end(), by_edge_and_cut);
  out.crossed.assign(k.twin.size(), 0);
  for (const auto& crossing : out.crossings) {
    out.crossed[crossing.edge] = 1;
    if (k.twin[crossing.edge] != kNone) out.crossed[k.twin[crossing.edge]] = 1;
  }
  return out;
}

std::uint32_t Cuts::highest(const Complex& k, std::uint32_t side) const {
  if (crossed.empty() || !crossed[side]) return kNone;
  const auto after = std::upper_bound(
      crossings.begin(), crossings.end(), k.edge(side),
      [](std::uint32_t edge, const Crossing& crossing) { return edge < crossing.edge; });
  return (after - 1)->cut;
}

std::uint32_t Cuts::lowest(const Complex& k, std::uint32_t side) const {
  if (crossed.empty() || !crossed[side]) return kNone;
  return std::lower_bound(
             crossings.begin(), crossings.end(), k.edge(side),
             [](const Crossing& crossing, std::uint32_t edge) { return crossing.edge < edge; })
      ->cut;
}

std::uint32_t Cuts::next_above(const Complex& k, std::uint32_t cut) const {
  const std::uint32_t edge = k.edge(side[cut]);
  const auto after =
      std::upper_bound(crossings.begin(), crossings.end(), Crossing{edge, cut}, by_edge_and_cut);
  return after != crossings.end() && after->edge == edge ? after->cut : kNone;
}

}  // namespace crest::certify::reeb
