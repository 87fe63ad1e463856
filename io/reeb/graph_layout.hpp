// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the nodes and arcs of a Reeb graph are drawn: y is the value, x a column a branch.
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::io {

inline constexpr int kNoColumn = -1000000;

struct GraphLayout {
  std::vector<int> node_column, arc_column;  ///< kNoColumn: not drawn
  int columns = 0;
  std::size_t left_out = 0;  ///< arcs that are not drawn
};

/// Divides the graph into branches, ascending chains of arcs: at each node the arc whose branch
/// began lowest goes on into the one that reaches highest, and so forth. The longest branch of each
/// component takes a new column, every other one the free column nearest to the branch it leaves,
/// long ones first; a node stands in the column of the first of its branches to be placed.
/// `heights`: of the nodes, ascending with their position. Only the longest `most` branches are
/// placed. Cost: O(n log n) plus at most O(most^3).
GraphLayout lay_out(const reeb::ReebGraph& graph, const std::vector<double>& heights,
                    std::size_t most = 400);

}  // namespace crest::io
