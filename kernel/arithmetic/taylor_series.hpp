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

/// Bernstein coefficients of the monomials, row by row; entries err by at most 4 units roundoff.
template <int Order>
struct BernsteinTable {
  static constexpr int kCount = monomial_count(2, Order);
  std::array<std::array<double, kCount>, kCount> of{};  ///< [coefficient][monomial]
  BernsteinTable();
};
extern template struct BernsteinTable<3>;
extern template struct BernsteinTable<4>;
extern template struct BernsteinTable<5>;
template <int Order>
inline const BernsteinTable<Order> kBernstein{};

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

}  // namespace taylor

}  // namespace crest::kernel
