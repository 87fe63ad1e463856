// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The order of degenerate points round a tet's conic, and which of them its curve joins, exactly:
// for points that are closer to one another than doubles tell.
//
// Let v . C v = 0 be the conic, C traceless and det C not 0, and all v on one half of this cone. It
// is convex: three of them are in counterclockwise order, seen from inside, iff det(a, b, c) > 0.
// The tangent at v is C v x v; det C > 0: counterclockwise, as det(e, v, C v x v) = |v|^2 e . C v,
// which has the sign of e . C e for e inside, the eigenvector whose eigenvalue alone has its sign,
// that of det C. Each point is a simple zero of the coordinate of its face: the curve is on that
// side of it on which this coordinate gets the sign of the others, and arcs alternate.
// No two points are equal and no zero is double, so refining the roots' intervals ends.
#include <array>
#include <cstddef>
#include <vector>

#include "algorithms/modes/degenerate_exact.hpp"

namespace crest::modes {

struct ConicPoint {
  ExactPoint point;
  DegenerateType type;
  std::size_t opposite;  ///< the corner that its face is opposite to
};

/// Two places in a list of points; the arc runs counterclockwise from the first.
using Join = std::array<std::size_t, 2>;

/// Requires: the vanishing form's determinant is not 0; all points of the tet's faces, none on an
/// edge, an even number of them, not 0.
std::vector<Join> joins_round_conic(const SimplexForms<Integer, 4>& forms,
                                    std::vector<ConicPoint> points);

}  // namespace crest::modes
