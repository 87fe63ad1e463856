// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/reeb_graph.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "algorithms/reeb/contour_sweep.hpp"

namespace crest::reeb {
namespace {

ReebNode node_at(const StrandLists& strands, Index stop) {
  const Stop& s = strands.stops[stop];
  const Index lower = strands.lower_count(stop), upper = strands.upper_count(stop);
  ReebNode node{s.vertex, NodeKind::saddle, static_cast<std::uint8_t>(s.closed ? 0 : 1), 1, 0};
  if (lower == 0) {
    node.kind = NodeKind::minimum;
  } else if (upper == 0) {
    node.kind = NodeKind::maximum;
  } else {
    node.multiplicity = std::max(lower, upper) - 1;
  }
  // The lower link: a cycle at a maximum with a cyclic link, else a path for every run.
  const bool cycle = upper == 0 && s.closed;
  node.index = cycle ? 1 : 1 - static_cast<std::int32_t>(lower);
  return node;
}

Index count_components(const ReebGraph& graph) {
  std::vector<Index> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto find = [&](Index x) {
    while (parent[x] != x) x = parent[x] = parent[parent[x]];
    return x;
  };
  auto components = static_cast<Index>(graph.nodes.size());
  for (const ReebArc& arc : graph.arcs) {
    const Index a = find(arc.lower), b = find(arc.upper);
    if (a == b) continue;
    parent[std::max(a, b)] = std::min(a, b);
    --components;
  }
  return components;
}

std::vector<Index> stops_in_order(const OrderedComplex& complex, const StrandLists& strands) {
  std::vector<Index> stop_at(complex.rank.size(), kNone), stops;
  const auto count = static_cast<Index>(strands.stops.size() - 1);
  for (Index stop = 0; stop < count; ++stop)
    stop_at[complex.rank[strands.stops[stop].vertex]] = stop;
  stops.reserve(count);
  for (const Index stop : stop_at) {
    if (stop != kNone) stops.push_back(stop);
  }
  return stops;
}

/// The graph; if `arc_of_vertex` is given also the arcs of the vertices.
ReebGraph sweep(const OrderedComplex& complex, std::vector<Index>* arc_of_vertex) {
  const StrandLists strands = find_strands(complex, arc_of_vertex != nullptr);
  ContourSweep contours(strands);
  ReebGraph graph;
  const std::vector<Index> stops = stops_in_order(complex, strands);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    contours.announce(stops, i);
    const Stop& s = strands.stops[stops[i]];
    if (s.critical) {
      contours.pass_node(stops[i], static_cast<Index>(graph.nodes.size()));
      graph.nodes.push_back(node_at(strands, stops[i]));
    } else {
      (*arc_of_vertex)[s.vertex] = contours.pass_regular(stops[i]);
    }
  }
  // Sorted by lower node already.
  std::vector<ReebArc>& arcs = contours.arcs;
  std::vector<Index> by_place(arcs.size());
  std::iota(by_place.begin(), by_place.end(), Index{0});
  const auto key = [&](Index a) {
    return std::tuple(arcs[a].lower, arcs[a].upper, complex.rank[arcs[a].strand]);
  };
  for (std::size_t i = 0, j = 0; i < arcs.size(); i = j) {
    while (j < arcs.size() && arcs[j].lower == arcs[i].lower) ++j;
    if (j - i == 1) continue;
    std::sort(by_place.begin() + static_cast<std::ptrdiff_t>(i),
              by_place.begin() + static_cast<std::ptrdiff_t>(j),
              [&](Index a, Index b) { return key(a) < key(b); });
  }
  graph.arcs.reserve(arcs.size());
  for (const Index a : by_place) graph.arcs.push_back(arcs[a]);
  graph.components = count_components(graph);
  if (arc_of_vertex != nullptr) {
    std::vector<Index> place(arcs.size());
    for (Index i = 0; i < by_place.size(); ++i) place[by_place[i]] = i;
    for (Index& arc : *arc_of_vertex) {
      if (arc != kNone) arc = place[arc];
    }
  }
  return graph;
}

}  // namespace

ReebGraph reeb_graph(const OrderedComplex& complex) {
  return sweep(complex, nullptr);
}

std::vector<Index> arc_of_vertices(const OrderedComplex& complex, const ReebGraph& graph) {
  std::vector<Index> arcs(complex.rank.size(), kNone);
  const ReebGraph same = sweep(complex, &arcs);
  if (same.arcs.size() != graph.arcs.size() || same.nodes.size() != graph.nodes.size()) {
    throw std::invalid_argument("the graph is not that of the complex");
  }
  return arcs;
}

}  // namespace crest::reeb
