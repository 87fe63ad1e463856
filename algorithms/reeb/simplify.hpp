// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reeb graphs without their small features, and as trees of branches.
#include <span>
#include <vector>

#include "algorithms/reeb/persistence.hpp"

namespace crest::reeb {

/// A graph made of another one.
struct CoarserGraph {
  /// Nodes are as they were. A node of degree 2, one arc below and one above, is none any more: its
  /// arcs are one, with the strand (an edge at the lower arc's own lower vertex) and open_below of
  /// the lower one and open_above of the upper one.
  ReebGraph graph;
  std::vector<Index> arc_of_arc;  ///< for every old arc the new one that has taken it up
};

/// Cancels, smallest first and as long as there are any with persistence <= p:
///   leaf arcs, from a minimum (maximum) to a node with another arc below (above) it: the arc goes
///   to one that stays at that node;
///   with `loops`, two arcs with the same ends: they become one. (A loop with other nodes on it is
///   kept until they are cancelled; the persistence is that of its pair.)
/// Nodes that have one arc below and one above become part of an arc, those that had so at first
/// included. Persistence is the difference of the ends' values; of equal ones that with fewer nodes
/// between its ends in the order goes first, then that with the lower number.
/// `values`: of the vertices of the graph's complex, ascending with the nodes.
/// Cost: O(c log c).
CoarserGraph simplify(const ReebGraph& graph, std::span<const double> values, double p,
                      bool loops = false);

/// A path of arcs upwards from `lower` to `upper`.
struct Branch {
  PairKind kind;  ///< minimum, maximum: cancelled; component, loop: left at last
  Index lower, upper;
  double persistence;
  std::vector<Index> arcs;  ///< from below
};

/// The branch decomposition: every arc is in one branch. The leaf arcs as simplify cancels them for
/// p without end, in that order, then what is left: of a tree one branch (mostly from its lowest to
/// its highest node, but not every tree can be taken down to these leaf by leaf), of other
/// components, kind loop, the arcs between the nodes left.
/// Source: Pascucci, Cole-McLaughlin, Scorzelli, Multi-resolution computation and presentation of
/// contour trees (2004).
/// Cost: O(c log c).
std::vector<Branch> branch_decomposition(const ReebGraph& graph, std::span<const double> values);

}  // namespace crest::reeb
