// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/arc_flood.hpp"

#include <algorithm>

#include "kernel/geometry/stop.hpp"

namespace crest::reeb {

ArcFlood::ArcFlood(const OrderedComplex& complex, VertexStars& stars, const SweptGraph& swept)
    : complex_(complex),
      stars_(stars),
      swept_(swept),
      arc_of_(complex.rank.size(), kNone),
      is_node_(complex.rank.size(), 0),
      only_below_(swept.graph.nodes.size(), kNone),
      only_above_(swept.graph.nodes.size(), kNone) {
  const auto& arcs = swept.graph.arcs;
  const auto rank_of = [&](Index node) { return complex.rank[swept.graph.nodes[node].vertex]; };
  for (const ReebArc& arc : arcs) span_.push_back({rank_of(arc.lower), rank_of(arc.upper)});
  std::vector<Index> below(only_below_.size(), 0), above(below);
  for (Index a = 0; a < arcs.size(); ++a) {
    only_above_[arcs[a].lower] = ++above[arcs[a].lower] == 1 ? a : kNone;
    only_below_[arcs[a].upper] = ++below[arcs[a].upper] == 1 ? a : kNone;
  }
  for (const ReebNode& node : swept.graph.nodes) is_node_[node.vertex] = 1;
  start_at_nodes();
  flood();
  go_past_nodes();
}

std::vector<std::uint8_t> ArcFlood::unlabelled() const {
  std::vector<std::uint8_t> marks(arc_of_.size(), 0);
  bool any = false;
  for (std::size_t v = 0; v < marks.size(); ++v) {
    marks[v] = arc_of_[v] == kNone && is_node_[v] == 0;
    any = any || marks[v] != 0;
  }
  return any ? marks : std::vector<std::uint8_t>();
}

bool ArcFlood::on_arc(Index v, Index arc) const {
  return span_[arc][0] < complex_.rank[v] && complex_.rank[v] < span_[arc][1];
}

void ArcFlood::label(Index v, Index arc) {
  arc_of_[v] = arc;
  queue_.push_back(v);
}

void ArcFlood::start_at_nodes() {
  const StrandLists& strands = swept_.strands;
  Link link;
  for (Index stop = 0; stop + 1 < strands.stops.size(); ++stop) {
    kernel::stop_point();
    const Index v = strands.stops[stop].vertex;
    stars_.link(v, link);
    rotate_to_lower_run(link, complex_.rank, v);
    const auto is_lower = [&](Index w) { return complex_.rank[w] < complex_.rank[v]; };
    Index lower = strands.stops[stop].lower_begin, upper = strands.stops[stop].upper_begin;
    for (std::size_t i = 0; i < link.vertices.size(); ++i) {
      const Index w = link.vertices[i];
      if (i > 0 && is_lower(link.vertices[i - 1]) != is_lower(w)) ++(is_lower(w) ? upper : lower);
      const Index arc =
          is_lower(w) ? swept_.arc_of_lower_run[lower] : swept_.arc_of_upper_run[upper];
      if (arc_of_[w] == kNone && on_arc(w, arc)) label(w, arc);
    }
  }
}

void ArcFlood::flood() {
  while (!queue_.empty()) {
    kernel::stop_point();
    const Index v = queue_.back(), arc = arc_of_[v];
    const auto [low, high] = span_[arc];
    queue_.pop_back();
    for (const VertexStars::Side& side : stars_.star(v))
      for (const Index w : side)
        if (arc_of_[w] == kNone && low < complex_.rank[w] && complex_.rank[w] < high) label(w, arc);
  }
}

/// Along an edge from a vertex of the arc to v; kNone where it meets a node with several arcs on
/// the other side, or too many nodes.
Index ArcFlood::walk(Index arc, Index v) const {
  for (int most = 32; most > 0 && arc != kNone; --most) {
    if (on_arc(v, arc)) return arc;
    const ReebArc& a = swept_.graph.arcs[arc];
    const bool up = complex_.rank[v] > span_[arc][1];
    arc = up ? only_above_[a.upper] : only_below_[a.lower];
  }
  return kNone;
}

bool ArcFlood::label_by_walk(Index v) {
  for (const VertexStars::Side& side : stars_.star(v)) {
    for (const Index w : side) {
      const Index arc = arc_of_[w] == kNone ? kNone : walk(arc_of_[w], v);
      if (arc == kNone) continue;
      label(v, arc);
      flood();
      return true;
    }
  }
  return false;
}

/// Rounds go on while each labels half of what was left, so all of them cost O(n).
void ArcFlood::go_past_nodes() {
  std::vector<Index> left;
  for (const Index v : complex_.order)
    if (arc_of_[v] == kNone && is_node_[v] == 0) left.push_back(v);
  for (std::size_t before = 2 * left.size(); !left.empty() && 2 * left.size() <= before;) {
    before = left.size();
    std::erase_if(left, [&](Index v) { return arc_of_[v] != kNone || label_by_walk(v); });
  }
}

}  // namespace crest::reeb
