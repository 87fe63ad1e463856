// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Boundary saddles: line-critical points at which two contours of the face merge (paper 003,
// section 3.2: the derivative across the edge against the kind along it).
//
// At the line-critical point of c0 c1 the derivative towards c2 is (h p - g q) / p, so it is
// opposite to the second derivative 4 p iff centre_side (face_critical.hpp) is positive. If it is
// zero the point is the centre itself, a saddle iff H < 0.
//
// Laws. (1) invariant under exchanging c0 and c1. (2) even. (3) a face without a face-critical
// point and with two line-critical points has at most one boundary saddle (docs/
// reeb-tessellation.md). (4) depends on c0 c1 and the side only through the face's function.
#include "kernel/predicates/face_critical.hpp"

namespace crest::kernel {

/// Zero derivative: the sign of H decides, negative for a saddle.
inline Sign exact_boundary_saddle(const FaceValues& f) {
  const Sign side = exact_centre_side({f});
  return side != Sign::zero ? side : -exact_hessian({f});
}

/// For the line-critical point of the side c0 c1: positive iff it is a boundary saddle; negative:
/// an extremum of the face near it; zero: it lies on a line of critical points.
/// Requires: the side has a line-critical point.
Decision boundary_saddle(const FaceValues& f);

}  // namespace crest::kernel
