// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Least-squares fit of bivariate polynomials to points of a surface (jet fitting, Cazals and
// Pouget 2003), by normal equations whose Gram matrix is built from moments.
#include <array>
#include <span>

#include "algorithms/ridges/lanes.hpp"

namespace crest::ridges {

/// z = sum of c[m] x^a y^b over the monomials of degree <= 4 in the order
/// 1, x, y, x2, xy, y2, x3, x2y, xy2, y3, x4, x3y, x2y2, xy3, y4.
struct Jet {
  std::array<double, 15> c{};
  int degree = 0;        ///< 4, 3, 2 or 1: what the points determine
  double condition = 0;  ///< max |r_ii| / min |r_ii| of the triangular factor, a lower estimate
  double residual = 0;  ///< s: s^2 = |r|^2 / (points - coefficients), at least what rounding leaves
};

inline constexpr int kMonomials = 15;
inline constexpr int kMoments = 45;  // x^a y^b, a + b <= 8

struct MomentSums {
  Lanes moment[kMoments];
  Lanes value[kMonomials];  // sum of z x^a y^b
  Lanes square;             // sum of z^2
};

/// 15 columns of the Gram matrix (upper triangle) and the right-hand side. After elimination row j
/// holds the factor's row and y_j: G = U^T U, U^T y = right-hand side.
struct NormalEquations {
  Lanes row[kMonomials][kMonomials + 1];
  Lanes inverse[kMonomials];  // 1 / u_jj, or 0 for a column that is not used
};

/// Four fits side by side, which may be given more points and asked how they carry errors on.
class JetFit {
 public:
  /// Requires: max_degree 3 or 4.
  explicit JetFit(int max_degree);

  /// The fit to these rows and all given before; count[j]: points of lane j so far.
  /// Requires: local coordinates scaled to about 1. The number of points, not a tolerance on
  /// values, and the pivots' loss of digits (a column within 1e-4 of the span of the earlier ones)
  /// lower the degree: then only the leading coefficients are set.
  /// Cost: 60 sums over the points, a 15 x 15 Cholesky factorisation.
  std::array<Jet, kLanes> fit(std::span<const PointLanes> rows,
                              const std::array<std::size_t, kLanes>& count);

  /// A quantity's derivatives by the coefficients x, y, x2, xy, y2, by lane; by[0] is not read.
  struct Gradient {
    Lanes by[6];
  };
  /// |U^-T g| for each gradient g, where G = U^T U is the Gram matrix: the quantity's standard
  /// error if the points' heights have independent errors of variance 1.
  /// Cost: a triangular solve.
  std::array<double, kLanes> propagate(const Gradient& gradient) const;

 private:
  Jet jet_of(std::size_t lane, std::size_t count, int degree) const;

  int max_degree_;
  MomentSums sums_{};
  NormalEquations equations_;
  Lanes solution_[kMonomials];
};

}  // namespace crest::ridges
