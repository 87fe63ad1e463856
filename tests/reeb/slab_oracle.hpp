// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Reeb graph by brute force: all contours of all slabs between neighbouring ranks.
#include <tuple>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::tests {

/// Vertex, kind, on the boundary, multiplicity, index.
using OracleNode = std::tuple<kernel::Index, reeb::NodeKind, bool, std::uint32_t, std::int32_t>;
/// Ranks of lower and upper vertex and strand; whether the contours are paths.
using OracleArc = std::tuple<kernel::Index, kernel::Index, kernel::Index, bool>;

struct OracleGraph {
  std::vector<OracleNode> nodes;         ///< in the order
  std::vector<OracleArc> arcs;           ///< sorted
  std::vector<OracleArc> arc_of_vertex;  ///< not meant for nodes
  /// Just above the lowest, just above the middle, just below the highest vertex.
  std::vector<std::array<OracleArc, 3>> arcs_of_triangle;
  kernel::Index components = 0;
};

/// Cost: O(n^2).
OracleGraph slab_oracle(const reeb::OrderedComplex& complex);

/// An arc as the oracle names it.
OracleArc named(const reeb::OrderedComplex& complex, const reeb::ReebGraph& graph,
                kernel::Index arc);

/// A graph as the oracle names its parts (without arcs_of_triangle).
OracleGraph named(const reeb::OrderedComplex& complex, const reeb::ReebGraph& graph,
                  const std::vector<kernel::Index>& arc_of_vertex);

}  // namespace crest::tests
