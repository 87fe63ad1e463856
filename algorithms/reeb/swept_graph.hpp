// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A Reeb graph together with what the sweep knows about vertices and links.
#include <vector>

#include "algorithms/reeb/strands.hpp"

namespace crest::reeb {

struct SweptGraph {
  ReebGraph graph;
  StrandLists strands;
  std::vector<Index> arc_of_vertex;                       ///< of stops; kNone at nodes and others
  std::vector<Index> arc_of_lower_run, arc_of_upper_run;  ///< by the runs of the stops
};

/// Stops at the critical vertices and those `asked` for (a mark a vertex; empty: none).
SweptGraph sweep(const OrderedComplex& complex, VertexStars& stars,
                 std::span<const std::uint8_t> asked);

}  // namespace crest::reeb
