// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cut: a contour along which a certificate opens the surface (certify/reeb/SPEC.md, theorem 6).
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// Arcs to cut, ascending, so that the graph becomes a forest and every part of the surface, its
/// cuts closed by cones, has Euler characteristic at least 1 or at most one saddle.
/// On a closed orientable surface with as many loops as its genus these are as many arcs as there
/// are loops. Otherwise one more for every saddle or hole that takes part in a handle, a cross-cap
/// or a second boundary loop of a part, and at worst all arcs between saddles.
/// Cost: O(n log n) for n nodes and arcs.
std::vector<Index> choose_cuts(const ReebGraph& graph);

/// The index of the cones that close the cut of an arc: of the maximum on the part below it and of
/// the minimum on the part above it.
struct ConeIndices {
  std::int32_t below, above;
};
inline ConeIndices cone_indices(const ReebArc& arc) {
  return {arc.open_below ? 0 : 1, 1};
}

}  // namespace crest::reeb
