// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which part of the surface belongs to which arc of its Reeb graph.
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// The arcs of three contours of a triangle: just above its lowest, just above its middle, and just
/// below its highest vertex. (Between them a contour may pass nodes elsewhere on the surface: a
/// triangle can meet any number of arcs, a path in the graph from `lowest` up to `highest`.)
struct TriangleArcs {
  Index lowest, middle, highest;
};

struct Segmentation {
  std::vector<Index> arc_of_vertex;  ///< kNone at nodes
  std::vector<TriangleArcs> triangles;
};

/// Requires: the graph is that of the complex. Throws: std::invalid_argument if its numbers of
/// nodes and arcs are others. Cost: O(n log n).
Segmentation segmentation(const OrderedComplex& complex, const ReebGraph& graph);

}  // namespace crest::reeb
