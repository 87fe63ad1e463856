// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A Reeb graph with the arcs that nodes and tiles of the tessellation belong to, which simplifying
// keeps up.
#include <optional>

#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"

namespace crest::reeb {

struct LabelledGraph {
  ReebGraph graph;
  std::vector<Index> arc_of_node;  ///< of each node of the tiles, kNone at the graph's; or empty
  std::vector<Index> arc_of_tile;  ///< that of the contour just above its middle node; or empty
};

/// Fills the labels, of tiles only if asked to. Requires: the graph of `tiles`.
void label(const TileComplex& tiles, bool segmentation, LabelledGraph& labelled);

struct Simplification {
  bool contract = false;              ///< arcs between equal values (contraction.hpp)
  std::optional<double> persistence;  ///< then cancel up to it (simplify.hpp)
  bool cancel_loops = false;

  bool wanted() const { return contract || persistence.has_value(); }
};

/// Which of these took something away.
struct Simplified {
  bool contract = false, persistence = false, cancel_loops = false;
};

/// Requires: `values` of the tiles' nodes if there is a persistence.
Simplified simplify(const TileComplex& tiles, std::span<const double> values,
                    const Simplification& wanted, LabelledGraph& labelled);

}  // namespace crest::reeb
