// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What Taylor models are made with: bounds of rounded sums, series of elementary functions with
// their remainders, Bernstein coefficients of monomials on the triangle of taylor_model.hpp.
#include <array>
#include <cmath>

#include "kernel/arithmetic/monomials.hpp"

namespace crest::kernel {

/// An upper bound of the exact value of a non-negative number computed in at most 2^8 operations.
inline double grow(double x) {
  return x * (1 + 0x1p-43) + 0x1p-1000;
}

namespace taylor {

/// Taylor coefficients t[0..n] of a function at c, each within error[k] of the exact one, and a
/// bound on |f(c + h) - sum t_k h^k| / |h|^(n + 1) (exact t) for |h| <= rho. Not finite where the
/// function is not analytic on [c - rho, c + rho].
struct Series {
  std::array<double, 8> t{}, error{};
  double rest = HUGE_VAL;
};
Series inverse_series(double c, double rho, int order);
Series sqrt_series(double c, double rho, int order);
Series exp_series(double c, double rho, int order);
Series log_series(double c, double rho, int order);
Series sin_series(double c, double rho, int order);
Series cos_series(double c, double rho, int order);

/// A lower bound of the exact value of a positive number computed in a few operations; at most 0
/// for what may be zero.
inline double shrink(double x) {
  return x * (1 - 0x1p-43) - 0x1p-1000;
}
/// x / y for a product y; infinite where y may have lost digits to underflow, or more than grow()
/// makes up for to overflow.
inline double over(double x, double y) {
  return y > 0x1p-960 && (y < HUGE_VAL || x <= 1) ? x / y : HUGE_VAL;
}

constexpr double weight(int i, int j) {
  double w = 1;
  for (int k = 0; k < i && k < j; ++k) w /= 2;
  return w;
}

template <int Order>
struct Weights {
  std::array<double, monomial_count(2, Order)> of{};
  std::array<int, monomial_count(2, Order)> degree{};
  constexpr Weights() {
    const Monomials<2, Order> table;
    for (std::size_t m = 0; m < of.size(); ++m) {
      of[m] = weight(table.exponents[m][0], table.exponents[m][1]);
      degree[m] = table.exponents[m][0] + table.exponents[m][1];
    }
  }
};

/// Bernstein coefficients of the monomials on the triangle; entries err by at most 1 unit roundoff.
/// Row (i, j) belongs to l0^(Order - i - j) l1^i l2^j, (i, j) as in Monomials.
template <int Order>
struct BernsteinTable {
  static constexpr int kCount = monomial_count(2, Order);
  std::array<std::array<double, kCount>, kCount> of{};  ///< [row][monomial]

  // u = (2 l1 - l0 - l2) / 2, v = (2 l2 - l0 - l1) / 2, 1 = l0 + l1 + l2: u^i v^j as a homogeneous
  // polynomial of degree Order; its coefficients over the multinomial ones.
  constexpr BernsteinTable() {
    const Monomials<2, Order> table;
    for (std::size_t m = 0; m < kCount; ++m) {
      Homogeneous p{};
      p[0][0] = 1;
      const int i = table.exponents[m][0], j = table.exponents[m][1];
      for (int n = 0; n < i; ++n) p = times(p, -0.5, 1, -0.5);
      for (int n = 0; n < j; ++n) p = times(p, -0.5, -0.5, 1);
      for (int n = i + j; n < Order; ++n) p = times(p, 1, 1, 1);
      for (std::size_t row = 0; row < kCount; ++row) {
        const int a1 = table.exponents[row][0], a2 = table.exponents[row][1];
        const double multinomial =
            factorial(Order) / (factorial(a1) * factorial(a2) * factorial(Order - a1 - a2));
        of[row][m] = p[static_cast<std::size_t>(a1)][static_cast<std::size_t>(a2)] / multinomial;
      }
    }
  }

 private:
  /// Homogeneous in l0, l1, l2; [a1][a2] is the coefficient of l1^a1 l2^a2 times the missing power
  /// of l0. Exact: multiples of 2^-5 below 4^5.
  using Homogeneous = std::array<std::array<double, Order + 1>, Order + 1>;
  static constexpr Homogeneous times(const Homogeneous& p, double c0, double c1, double c2) {
    Homogeneous r{};
    for (std::size_t i = 0; i <= Order; ++i)
      for (std::size_t j = 0; j <= Order; ++j)
        r[i][j] = c0 * p[i][j] + (i > 0 ? c1 * p[i - 1][j] : 0) + (j > 0 ? c2 * p[i][j - 1] : 0);
    return r;
  }
  static constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }
};

}  // namespace taylor

}  // namespace crest::kernel
