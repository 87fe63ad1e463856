// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Standard errors of fitted curvatures. A jet's coefficients c solve the least squares A c = z with
// Gram matrix G = A^T A = U^T U. Independent errors of variance s^2 in the heights z give
//   sigma_q = s |U^-T g|,  g = dq / dc,  for q in {k1, k2, k1 - k2}.
// s_v is the residual at v, s_v^2 = |r|^2 / (points - 15), clamped to [1/2, 2] times its median
// over the vertices: noise is a property of the scan, the misfit at a crease is no noise; and never
// below the rounding of the coordinates.
#include <array>
#include <vector>

#include "algorithms/ridges/monge_from_jet.hpp"
#include "algorithms/ridges/ridge_graph.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::ridges {

/// dk1/dc and dk2/dc by the coefficients of x, y, x2, xy, y2 ([0] is 0), in the jet's units. A unit
/// tangent t of the graph has k(t) = h(t, t) / (w g(t, t)), h = 2 c3 a^2 + 2 c4 a b + 2 c5 b^2,
/// g = a^2 + b^2 + (c1 a + c2 b)^2 in its plane part (a, b), w^2 = 1 + c1^2 + c2^2; a principal
/// direction is stationary, so only the coefficients vary.
struct CurvatureGradients {
  std::array<double, 6> k1{}, k2{};
};
CurvatureGradients curvature_gradients(const Jet& jet, const PrincipalFrame& frame);

/// Multiplies the errors, given for residuals of 1 (units of the input), by s_v; those of a vertex
/// whose fit has a lower degree than 4 become infinite.
/// Shapes: residuals, qualities and errors V.
void scale_errors(const kernel::TriangleMesh& mesh, const std::vector<double>& residuals,
                  const std::vector<FitQuality>& quality, std::vector<CurvatureError>& errors);

}  // namespace crest::ridges
