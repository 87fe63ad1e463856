// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Least-squares fit of bivariate polynomials to points of a surface (jet fitting, Cazals and
// Pouget 2003), by normal equations whose Gram matrix is built from moments.
#include <array>

#include "algorithms/ridges/lanes.hpp"

namespace crest::ridges {

/// z = sum of c[m] x^a y^b over the monomials of degree <= 4 in the order
/// 1, x, y, x2, xy, y2, x3, x2y, xy2, y3, x4, x3y, x2y2, xy3, y4.
struct Jet {
  std::array<double, 15> c{};
  int degree = 0;          ///< 4, 3, 2 or 1: what the points determine
  double condition = 0;    ///< max |r_ii| / min |r_ii| of the triangular factor, a lower estimate
  double cubic_error = 0;  ///< estimated standard error of the cubic coefficients (largest)
};

/// Requires: local coordinates scaled to about 1. The number of points, not a tolerance on values,
/// and the pivots' loss of digits (a column within 1e-4 of the span of the earlier ones) lower the
/// degree: then only the leading coefficients are set.
/// Cost: 60 sums over the points, a 15 x 15 Cholesky factorisation.
std::array<Jet, kLanes> fit_jets(const NeighbourhoodLanes& local, int max_degree);

}  // namespace crest::ridges
