// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the parts of a surface below (join tree) and above (split tree) a level merge.
#include <array>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// Nodes are vertices, those of a join tree ascending in the order, those of a split tree
/// descending; `parent` is the position of the next node towards the root (kNone: a root, the last
/// vertex of its component).
struct MergeTree {
  std::vector<Index> vertices;
  std::vector<Index> parent;
};

/// With all critical vertices as nodes. Cost: O(n) for n vertices, with almost constant factors for
/// the critical ones. Source: Chiang, Lenz, Lu, Rote, Simple and optimal output-sensitive
/// construction of contour trees using monotone paths (2005): the strands.
MergeTree augmented_join_tree(const OrderedComplex& complex);
MergeTree augmented_split_tree(const OrderedComplex& complex);

/// Only leaves, vertices where parts merge, and roots.
MergeTree reduced(const MergeTree& tree);

/// The same trees of a Reeb graph (they are those of its surface), nodes as positions in
/// graph.nodes instead of vertices. Cost: almost O(c) for c nodes and arcs.
MergeTree augmented_join_tree(const ReebGraph& graph);
MergeTree augmented_split_tree(const ReebGraph& graph);

/// The arcs of a merge tree of this graph between vertices, lower first.
std::vector<std::array<Index, 2>> arcs_of(const ReebGraph& graph, const MergeTree& tree);

}  // namespace crest::reeb
