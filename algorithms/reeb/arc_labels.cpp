// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/arc_labels.hpp"

#include <algorithm>
#include <unordered_set>

namespace crest::reeb {

std::vector<Index> relabel_arcs(const std::vector<Index>& arc_of_thing,
                                const std::vector<Index>& arc_of_arc) {
  std::vector<Index> result = arc_of_thing;
  for (Index& arc : result)
    if (arc != kNone) arc = arc_of_arc[arc];
  return result;
}

std::vector<Index> relabel_vertices(const std::vector<Index>& arc_of_vertex,
                                    const ReebGraph& before, const ContractedGraph& after) {
  // What lay on a contracted arc is where its ends are: at a node, or on the arc that runs there.
  std::vector<Index> arc_of_arc = after.arc_of_arc;
  for (std::size_t a = 0; a < arc_of_arc.size(); ++a)
    if (arc_of_arc[a] == kNone) arc_of_arc[a] = after.arc_of_node[before.arcs[a].lower];
  std::vector<Index> result = relabel_arcs(arc_of_vertex, arc_of_arc);
  for (std::size_t i = 0; i < before.nodes.size(); ++i)
    result[before.nodes[i].vertex] = after.arc_of_node[i];
  return result;
}

std::vector<Index> relabel_vertices(const std::vector<Index>& arc_of_vertex,
                                    const ReebGraph& before, const CoarserGraph& after) {
  std::vector<Index> result = relabel_arcs(arc_of_vertex, after.arc_of_arc);
  std::unordered_set<Index> kept;
  for (const ReebNode& node : after.graph.nodes) kept.insert(node.vertex);
  for (std::size_t a = 0; a < before.arcs.size(); ++a) {
    for (const Index end : {before.arcs[a].lower, before.arcs[a].upper}) {
      const Index vertex = before.nodes[end].vertex;
      if (!kept.contains(vertex)) result[vertex] = std::min(result[vertex], after.arc_of_arc[a]);
    }
  }
  return result;
}

}  // namespace crest::reeb
