// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Distances over the surface from a set of vertices, by fast marching on triangles (R. Kimmel and
// J. A. Sethian, Computing geodesic paths on manifolds, 1998).
#include <cmath>

#include "algorithms/feature_lines/marks.hpp"

namespace crest::feature_lines {

/// One distance a vertex, in units of the input: 0 at the marked vertices, infinite at those
/// farther than `limit` or not reached. Where a corner is obtuse, the faces behind it are unfolded
/// until a vertex splits it into two acute ones; a corner whose unfolding leaves the mesh is used
/// as it is. Guarantees: never more than the length of the shortest path along edges, in the same
/// rounding;
///   exact in a plane for a straight front.
/// Not true: that these are geodesics to the last digit; the error is of first order in the edge
///   length, and largest close to a single source.
/// Deterministic. Cost: O(V log V); a corner is unfolded over at most 32 faces.
std::vector<double> geodesic_distances(const kernel::TriangleMesh& mesh, const Marks& marks,
                                       double limit = HUGE_VAL);

}  // namespace crest::feature_lines
