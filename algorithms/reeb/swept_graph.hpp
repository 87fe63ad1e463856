// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A Reeb graph together with what the sweep knows about vertices and links.
#include <vector>

#include "algorithms/reeb/strands.hpp"

namespace crest::reeb {

struct SweptGraph {
  ReebGraph graph;
  /// Only after a sweep with all vertices as stops:
  std::vector<Index> arc_of_vertex;                       ///< kNone at nodes
  StrandLists strands;                                    ///< its stops are all vertices by number
  std::vector<Index> arc_of_lower_run, arc_of_upper_run;  ///< by the runs of the stops
};

SweptGraph sweep(const OrderedComplex& complex, bool all_vertices);

}  // namespace crest::reeb
