// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Extended persistence of a Reeb graph.
#include <span>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// What the two nodes of a pair, lower < upper, begin and end:
///   minimum    a component of what lies below a level, from a minimum to the node where it merges
///              with one that has a lower minimum;
///   maximum    the same from above: from the node where it merges up to the maximum;
///   component  a component of the surface: its lowest and highest node;
///   loop       a loop: the highest node of a cycle of arcs and the highest among the lowest nodes
///              of all such cycles (Agarwal, Edelsbrunner, Harer, Wang, Extreme elevation on a
///              2-manifold, 2006). This is the extended part: neither end ends in ordinary
///              persistence.
/// (The surface has more one-dimensional classes than its graph; those are not in the pairs.)
enum class PairKind : std::uint8_t { minimum, maximum, component, loop };

struct PersistencePair {
  PairKind kind;
  Index lower, upper;  ///< nodes
  double persistence;  ///< difference of their values
};

/// Sorted by persistence, then kind, lower, upper. Every minimum and maximum is in exactly one
/// pair, the lowest and highest of a component in `component`; as many loops as graph.loops().
/// `values`: of the vertices of the graph's complex, ascending with the nodes.
/// Cost: O(c log c) for c nodes and arcs, and for every loop the depth of a forest of arcs.
std::vector<PersistencePair> persistence_pairs(const ReebGraph& graph,
                                               std::span<const double> values);

}  // namespace crest::reeb
