// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Reeb graph of the function itself, which knows nothing of how ties were broken.
#include <span>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// The nodes joined by arcs between equal values, each group named by one of its nodes.
std::vector<Index> tied_groups(const ReebGraph& graph, std::span<const Index> rank,
                               std::span<const std::uint8_t> tied);

/// Arcs between equal values (certify/reeb/SPEC.md, "Ties") and the groups they join.
struct TieCounts {
  Index arcs = 0, groups = 0;
};
TieCounts count_ties(const ReebGraph& graph, std::span<const Index> rank,
                     std::span<const std::uint8_t> tied);

struct ContractedGraph {
  /// A node stands for all nodes joined by arcs between equal values (its vertex: the one of least
  /// number; its index: the sum of theirs; on_boundary: of any). Kinds are those of the degrees: no
  /// arc below, none above (or none at all: a minimum), both. Arcs are sorted by (lower, upper,
  /// strand), strands being edges at one of the joined nodes.
  /// What has one arc below and one above, both open or both closed, and index 0 is no node.
  ReebGraph graph;
  std::vector<Index> node_of_node, arc_of_arc;  ///< kNone: not one any more (it is on arc_of_node)
  std::vector<Index> arc_of_node;               ///< of old nodes inside new arcs, else kNone
};

/// Contracts all arcs between nodes of equal value. The result is the same up to the choice of
/// strands and representatives however the vertices are numbered.
/// `rank`: of the complex; `tied[r]`: the vertex of rank r has the value of the one of rank r - 1.
/// Cost: O(n + c log c).
ContractedGraph contract(const ReebGraph& graph, std::span<const Index> rank,
                         std::span<const std::uint8_t> tied);

}  // namespace crest::reeb
