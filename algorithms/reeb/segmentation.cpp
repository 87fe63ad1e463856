// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/segmentation.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/reeb/swept_graph.hpp"

namespace crest::reeb {
namespace {

/// The triangles at every node, the nodes in the order of the stops.
struct TrianglesAtNodes {
  std::vector<Index> begin, triangles;
  TrianglesAtNodes(const OrderedComplex& complex, const StrandLists& strands)
      : begin(strands.stops.size() + 1, 0) {
    const auto is_node = [&](Index v) { return strands.stops[v].critical != 0; };
    for (const Triangle& t : complex.triangles)
      for (const Index v : t) begin[v + 2] += is_node(v);
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    triangles.resize(begin.back());
    for (Index t = 0; t < complex.triangles.size(); ++t) {
      for (const Index v : complex.triangles[t])
        if (is_node(v)) triangles[begin[v + 1]++] = t;
    }
  }
};

}  // namespace

Segmentation segmentation(const OrderedComplex& complex, const ReebGraph& graph) {
  VertexStars stars(complex.triangles, static_cast<Index>(complex.rank.size()));
  const std::vector<std::uint8_t> everywhere(complex.rank.size(), 1);
  SweptGraph swept = sweep(complex, stars, everywhere);
  if (swept.graph.arcs.size() != graph.arcs.size() ||
      swept.graph.nodes.size() != graph.nodes.size())
    throw std::invalid_argument("the graph is not that of the complex");
  const auto& rank = complex.rank;
  const auto by_rank = [&](Index a, Index b) { return rank[a] < rank[b]; };
  Segmentation out;
  out.arc_of_vertex = std::move(swept.arc_of_vertex);
  std::vector<Triangle> sorted(complex.triangles.begin(), complex.triangles.end());
  for (Triangle& t : sorted) {
    std::sort(t.begin(), t.end(), by_rank);
    out.triangles.push_back(
        {out.arc_of_vertex[t[0]], out.arc_of_vertex[t[1]], out.arc_of_vertex[t[2]]});
  }
  // At nodes the arc depends on the run.
  const TrianglesAtNodes at(complex, swept.strands);
  std::vector<Index> arc_towards(rank.size(), kNone);
  Link link;
  for (const ReebNode& node : swept.graph.nodes) {
    const Index v = node.vertex;
    stars.link(v, link);
    rotate_to_lower_run(link, rank, v);
    Index lower = swept.strands.stops[v].lower_begin, upper = swept.strands.stops[v].upper_begin;
    Index previous = kNone;
    for (const Index w : link.vertices) {
      const bool is_lower = by_rank(w, v);
      if (previous != kNone && by_rank(previous, v) != is_lower) ++(is_lower ? upper : lower);
      arc_towards[w] = is_lower ? swept.arc_of_lower_run[lower] : swept.arc_of_upper_run[upper];
      previous = w;
    }
    for (Index k = at.begin[v]; k < at.begin[v + 1]; ++k) {
      const Index t = at.triangles[k];
      TriangleArcs& arcs = out.triangles[t];
      if (sorted[t][0] == v) arcs.lowest = arc_towards[sorted[t][1]];
      if (sorted[t][1] == v) arcs.middle = arc_towards[sorted[t][2]];
      if (sorted[t][2] == v) arcs.highest = arc_towards[sorted[t][1]];
    }
  }
  return out;
}

}  // namespace crest::reeb
