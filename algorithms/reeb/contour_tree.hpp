// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contour tree by merging join and split tree.
#include <vector>

#include "algorithms/reeb/merge_trees.hpp"

namespace crest::reeb {

struct ContourTree {
  std::vector<Index> vertices;             ///< the critical ones, ascending in the order
  std::vector<std::array<Index, 2>> arcs;  ///< positions in `vertices`, lower first; sorted
};

/// The arcs between vertices, lower first.
std::vector<std::array<Index, 2>> arcs_of(const ContourTree& tree);

/// Requires: every component of the surface has Euler characteristic at least 1 (a sphere, a disk
///   or a projective plane): only then are join and split tree sure to tell the whole.
/// Throws: std::invalid_argument otherwise (reeb_graph serves all surfaces).
/// Cost: O(n + c log c). Source: Carr, Snoeyink, Axen, Computing contour trees in all dimensions
///   (2003), section 4.
ContourTree contour_tree(const OrderedComplex& complex);

/// The merging alone. Requires: both trees are of one function, over the same nodes.
/// Throws: std::invalid_argument if no tree has them as join and split tree.
ContourTree merged(const MergeTree& join, const MergeTree& split);

}  // namespace crest::reeb
