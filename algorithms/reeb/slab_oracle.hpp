// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Reeb graph by brute force: all contours of all slabs between neighbouring ranks. A reference
// for tests and tables; it shares nothing with reeb_graph but the interface.
#include <tuple>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// Vertex, kind, on the boundary, multiplicity, index.
using OracleNode = std::tuple<Index, NodeKind, bool, std::uint32_t, std::int32_t>;
/// Ranks of lower and upper vertex and strand; whether the contours are paths.
using OracleArc = std::tuple<Index, Index, Index, bool>;

struct OracleGraph {
  std::vector<OracleNode> nodes;         ///< in the order
  std::vector<OracleArc> arcs;           ///< sorted
  std::vector<OracleArc> arc_of_vertex;  ///< not meant for nodes
  /// Just above the lowest, just above the middle, just below the highest vertex.
  std::vector<std::array<OracleArc, 3>> arcs_of_triangle;
  Index components = 0;
};

/// Cost: O(n^2).
OracleGraph slab_oracle(const OrderedComplex& complex);

/// An arc as the oracle names it.
OracleArc named(const OrderedComplex& complex, const ReebGraph& graph, Index arc);

/// A graph as the oracle names its parts (without arcs_of_triangle).
OracleGraph named(const OrderedComplex& complex, const ReebGraph& graph,
                  const std::vector<Index>& arc_of_vertex);

}  // namespace crest::reeb
