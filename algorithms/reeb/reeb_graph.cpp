// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <tuple>

#include "algorithms/reeb/arc_flood.hpp"
#include "algorithms/reeb/contour_sweep.hpp"
#include "algorithms/reeb/swept_graph.hpp"
#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::reeb {
namespace {

ReebNode node_at(const StrandLists& strands, Index stop) {
  const Stop& s = strands.stops[stop];
  const Index lower = strands.lower_count(stop), upper = strands.upper_count(stop);
  ReebNode node{s.vertex, NodeKind::saddle, static_cast<std::uint8_t>(s.closed ? 0 : 1), 1, 0};
  if (lower == 0)
    node.kind = NodeKind::minimum;
  else if (upper == 0)
    node.kind = NodeKind::maximum;
  else
    node.multiplicity = std::max(lower, upper) - 1;
  // The lower link: a cycle at a maximum with a cyclic link, else a path for every run.
  const bool cycle = upper == 0 && s.closed;
  node.index = cycle ? 1 : 1 - static_cast<std::int32_t>(lower);
  return node;
}

Index count_components(const ReebGraph& graph) {
  kernel::DisjointSets parts(static_cast<Index>(graph.nodes.size()));
  for (const ReebArc& arc : graph.arcs) parts.unite(arc.lower, arc.upper);
  return parts.count();
}

std::vector<Index> stops_in_order(const OrderedComplex& complex, const StrandLists& strands) {
  std::vector<Index> stop_at(complex.rank.size(), kNone), stops;
  const auto count = static_cast<Index>(strands.stops.size() - 1);
  for (Index stop = 0; stop < count; ++stop)
    stop_at[complex.rank[strands.stops[stop].vertex]] = stop;
  stops.reserve(count);
  for (const Index stop : stop_at)
    if (stop != kNone) stops.push_back(stop);
  return stops;
}

/// Places of the arcs in the order (lower, upper, rank of strand). They come by lower node.
std::vector<Index> sorted_arcs(const std::vector<ReebArc>& arcs, std::span<const Index> rank) {
  std::vector<Index> order(arcs.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index a) { return std::tuple(arcs[a].upper, rank[arcs[a].strand]); };
  for (std::size_t i = 0, j = 0; i < arcs.size(); i = j) {
    while (j < arcs.size() && arcs[j].lower == arcs[i].lower) ++j;
    if (j - i == 1) continue;
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(i),
              order.begin() + static_cast<std::ptrdiff_t>(j),
              [&](Index a, Index b) { return key(a) < key(b); });
  }
  return order;
}

}  // namespace

SweptGraph sweep(const OrderedComplex& complex, VertexStars& stars,
                 std::span<const std::uint8_t> asked) {
  SweptGraph out;
  out.strands = find_strands(complex, stars, asked);
  out.arc_of_vertex.assign(asked.size(), kNone);
  ContourSweep contours(out.strands);
  ReebGraph& graph = out.graph;
  const std::vector<Index> stops = stops_in_order(complex, out.strands);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    kernel::stop_point();
    contours.announce(stops, i);
    const Stop& s = out.strands.stops[stops[i]];
    if (s.critical) {
      contours.pass_node(stops[i], static_cast<Index>(graph.nodes.size()));
      graph.nodes.push_back(node_at(out.strands, stops[i]));
    } else {
      out.arc_of_vertex[s.vertex] = contours.pass_regular(stops[i]);
    }
  }
  const std::vector<Index> order = sorted_arcs(contours.arcs, complex.rank);
  graph.arcs.reserve(order.size());
  for (const Index a : order) graph.arcs.push_back(contours.arcs[a]);
  graph.components = count_components(graph);
  std::vector<Index> place(order.size());
  for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
  out.arc_of_lower_run = std::move(contours.arc_of_lower_run);
  out.arc_of_upper_run = std::move(contours.arc_of_upper_run);
  for (auto* list : {&out.arc_of_vertex, &out.arc_of_lower_run, &out.arc_of_upper_run}) {
    for (Index& arc : *list)
      if (arc != kNone) arc = place[arc];
  }
  return out;
}

ReebGraph reeb_graph(const OrderedComplex& complex) {
  VertexStars stars(complex.triangles, static_cast<Index>(complex.rank.size()));
  return sweep(complex, stars, {}).graph;
}

GraphAndArcs reeb_graph_and_arcs(const OrderedComplex& complex) {
  VertexStars stars(complex.triangles, static_cast<Index>(complex.rank.size()));
  SweptGraph swept = sweep(complex, stars, {});
  ArcFlood flood(complex, stars, swept);
  std::vector<Index> labels = flood.labels();
  const std::vector<std::uint8_t> rest = flood.unlabelled();
  if (!rest.empty()) {
    const SweptGraph again = sweep(complex, stars, rest);
    for (std::size_t v = 0; v < rest.size(); ++v)
      if (rest[v] != 0) labels[v] = again.arc_of_vertex[v];
  }
  return {std::move(swept.graph), std::move(labels)};
}

}  // namespace crest::reeb
