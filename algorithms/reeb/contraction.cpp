// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/contraction.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::reeb {
namespace {

struct Group {
  Index below = 0, above = 0;
  Index arc_below = kNone, arc_above = kNone;
  std::int32_t index = 0;
  std::uint8_t on_boundary = 0;
  Index vertex = kNone;
};

class Contraction {
 public:
  Contraction(const ReebGraph& graph, std::vector<Index> group)
      : graph_(graph), group_(std::move(group)), groups_(graph.nodes.size()) {
    for (Index i = 0; i < group_.size(); ++i) {
      Group& g = groups_[group_[i]];
      g.index += graph.nodes[i].index;
      g.on_boundary |= graph.nodes[i].on_boundary;
      g.vertex = std::min(g.vertex, graph.nodes[i].vertex);
    }
    for (Index a = 0; a < graph.arcs.size(); ++a) {
      if (is_contracted(a)) continue;
      Group &lower = groups_[group_[graph.arcs[a].lower]],
            &upper = groups_[group_[graph.arcs[a].upper]];
      ++lower.above;
      lower.arc_above = a;
      ++upper.below;
      upper.arc_below = a;
    }
  }

  ContractedGraph run() {
    number_nodes();
    number_arcs();
    for (Index i = 0; i < group_.size(); ++i) {
      const Group& g = groups_[group_[i]];
      if (out_.node_of_node[i] == kNone) out_.arc_of_node[i] = out_.arc_of_arc[g.arc_below];
    }
    return std::move(out_);
  }

 private:
  bool is_contracted(Index arc) const {
    return group_[graph_.arcs[arc].lower] == group_[graph_.arcs[arc].upper];
  }
  bool is_regular(const Group& g) const {
    return g.below == 1 && g.above == 1 && g.index == 0 &&
           graph_.arcs[g.arc_below].open_above == graph_.arcs[g.arc_above].open_below;
  }
  void number_nodes();
  void number_arcs();

  const ReebGraph& graph_;
  std::vector<Index> group_;
  std::vector<Group> groups_;
  ContractedGraph out_;
};

void Contraction::number_nodes() {
  out_.node_of_node.assign(group_.size(), kNone);
  out_.arc_of_node.assign(group_.size(), kNone);
  for (Index i = 0; i < group_.size(); ++i) {
    const Group& g = groups_[group_[i]];
    if (group_[i] != i) {
      out_.node_of_node[i] = out_.node_of_node[group_[i]];
      continue;
    }
    if (is_regular(g)) continue;
    out_.node_of_node[i] = static_cast<Index>(out_.graph.nodes.size());
    ReebNode node{g.vertex, NodeKind::saddle, g.on_boundary, 1, g.index};
    if (g.below == 0)
      node.kind = NodeKind::minimum;
    else if (g.above == 0)
      node.kind = NodeKind::maximum;
    else
      node.multiplicity = std::max({g.below, g.above, Index{2}}) - 1;
    out_.graph.nodes.push_back(node);
  }
  out_.graph.components = graph_.components;
}

void Contraction::number_arcs() {
  // Paths of arcs upwards from nodes that stay.
  std::vector<ReebArc> arcs;
  std::vector<Index> path(graph_.arcs.size(), kNone);
  for (Index a = 0; a < graph_.arcs.size(); ++a) {
    if (is_contracted(a) || out_.node_of_node[graph_.arcs[a].lower] == kNone) continue;
    ReebArc arc = graph_.arcs[a];
    arc.lower = out_.node_of_node[arc.lower];
    for (Index part = a;;) {
      path[part] = static_cast<Index>(arcs.size());
      const Index top = graph_.arcs[part].upper;
      arc.open_above = graph_.arcs[part].open_above;
      arc.upper = out_.node_of_node[top];
      if (arc.upper != kNone) break;
      part = groups_[group_[top]].arc_above;
    }
    arcs.push_back(arc);
  }
  std::vector<Index> order(arcs.size()), place(arcs.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::tuple(arcs[a].lower, arcs[a].upper, arcs[a].strand, a) <
           std::tuple(arcs[b].lower, arcs[b].upper, arcs[b].strand, b);
  });
  for (Index i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    out_.graph.arcs.push_back(arcs[order[i]]);
  }
  for (const Index p : path) out_.arc_of_arc.push_back(p == kNone ? kNone : place[p]);
}

}  // namespace

std::vector<Index> tied_groups(const ReebGraph& graph, std::span<const Index> rank,
                               std::span<const std::uint8_t> tied) {
  std::vector<Index> plateau(rank.size());
  for (std::size_t r = 0, p = 0; r < rank.size(); ++r) {
    p += r > 0 && tied[r] == 0;
    plateau[r] = static_cast<Index>(p);
  }
  kernel::DisjointSets groups(static_cast<Index>(graph.nodes.size()));
  for (const ReebArc& arc : graph.arcs) {
    const auto value = [&](Index node) { return plateau[rank[graph.nodes[node].vertex]]; };
    if (value(arc.lower) == value(arc.upper)) groups.unite(arc.lower, arc.upper);
  }
  std::vector<Index> group(groups.size());
  for (Index i = 0; i < group.size(); ++i) group[i] = groups.find(i);
  return group;
}

TieCounts count_ties(const ReebGraph& graph, std::span<const Index> rank,
                     std::span<const std::uint8_t> tied) {
  const std::vector<Index> group = tied_groups(graph, rank, tied);
  TieCounts counts;
  for (Index i = 0; i < group.size(); ++i) counts.groups += group[i] == i;
  for (const ReebArc& arc : graph.arcs) counts.arcs += group[arc.lower] == group[arc.upper];
  return counts;
}

ContractedGraph contract(const ReebGraph& graph, std::span<const Index> rank,
                         std::span<const std::uint8_t> tied) {
  return Contraction(graph, tied_groups(graph, rank, tied)).run();
}

}  // namespace crest::reeb
