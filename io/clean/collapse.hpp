// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Faces of area exactly zero taken out of an oriented surface without a change of its topology.
#include "io/clean/clean_up.hpp"
#include "io/clean/surface.hpp"

namespace crest::io {

/// For every face of area zero the first that is allowed of:
/// 1. An edge of zero length is collapsed; the lower vertex stays.
/// 2. Its middle corner lies on the longest side: that edge is flipped, so that no point moves. The
///    face across has an area, or its third corner lies inside that edge, too.
/// 3. The longest side is at the boundary: the face is left out.
/// 4. The middle corner is collapsed along the shorter side into its neighbour (a corner at the
///    boundary stays where it is).
/// Collapsing is allowed where the link condition holds (with the boundary as one more vertex), so
/// surfaces stay manifolds of the same topology; flipping where the new edge is not there yet;
/// leaving out where the boundary loop stays one.
/// Requires: an oriented manifold, finite points. Returns the faces of area zero that stay.
/// Cost: O(F), and O(n log n) for n faces of area zero that do not wait for each other.
std::vector<kernel::Index> collapse_flat_faces(Surface& surface, CleanUp& done);

}  // namespace crest::io
