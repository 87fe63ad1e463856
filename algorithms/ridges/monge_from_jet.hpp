// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From a polynomial height field to the Monge form of its graph at the origin's foot point.
#include "algorithms/ridges/jet_fit.hpp"
#include "kernel/geometry/monge_form.hpp"

namespace crest::ridges {

/// The graph z = jet(x, y) at (0, 0, c00), re-expressed as a height over its tangent plane in the
/// principal frame: with x = a d1 + b d2 + c n and W = |(-z_x, -z_y, 1)|, the equation
///   W c = Q(u, v) + C(u, v) + D(u, v),  (u, v) = plane part of x,
/// is solved for c(a, b) as a power series to order four (paper 002, equations 1 and 2).
/// d1 and n are in the jet's coordinates; units are the jet's. Terms above the jet's degree are
/// those of the polynomial (zero coefficients), not zero curvature.
kernel::MongeForm monge_form_of(const Jet& jet);

/// The principal curvatures and frame of the graph over the origin.
struct PrincipalFrame {
  kernel::Vec3 d1, d2, n;
  double k1, k2, w;  ///< w = |(-z_x, -z_y, 1)|
};
PrincipalFrame principal_frame(const Jet& jet);

}  // namespace crest::ridges
