// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Drawing ridges inside umbilic patches: polylines on the mesh, from the contour's crossings to the
// umbilic, that do not cross (paper 002, section 6.5; "Join" in certify/ridges_mesh/SPEC.md).
#include <functional>
#include <vector>

#include "algorithms/ridges/umbilics.hpp"

namespace crest::ridges {

/// The way of a contour crossing to the umbilic.
struct PatchLine {
  Index edge;
  Colour colour;
  std::vector<Vec3> points;  ///< from the umbilic (included) to the crossing (not), on the patch
};
/// A few: one a crossing of the contour.
struct PatchJoins {
  std::vector<PatchLine> lines;
  /// Throws: std::out_of_range if the contour is not crossed there.
  const std::vector<Vec3>& at(Index edge, Colour colour) const;
};

/// Position of a crossing between its edge's ends, 0 at the lower vertex.
using CrossingWeight = std::function<double(Index edge, Colour colour)>;

/// The lines follow the tree of triangles of least steps from the central triangle. The lines that
/// share a side of a triangle pass it in the order in which their contour crossings follow each
/// other around the patch, so chords in a triangle do not cross.
PatchJoins join_patch(const kernel::TriangleMesh& mesh, const EdgeStates& states,
                      const std::vector<Index>& owner, const Umbilic& umbilic, Index number,
                      const CrossingWeight& weight);

}  // namespace crest::ridges
