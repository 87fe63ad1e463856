// SPDX-License-Identifier: GPL-3.0-or-later
// The Taylor series of elementary functions, with bounds for what they leave out.
#include "kernel/arithmetic/taylor_series.hpp"

#include <mpfr.h>

namespace crest::kernel::taylor {
namespace {

constexpr double kUnit = 0x1p-53;

/// A lower bound of the exact value of a positive number computed in a few operations; at most 0
/// for what may be zero.
double shrink(double x) {
  return x * (1 - 0x1p-43) - 0x1p-1000;
}

/// Correctly rounded but for subnormal results.
template <class Function>
double rounded(Function function, double x, mpfr_rnd_t direction = MPFR_RNDN) {
  mpfr_t y;
  mpfr_init2(y, 53);
  mpfr_set_d(y, x, MPFR_RNDN);
  function(y, y, direction);
  const double result = mpfr_get_d(y, direction);
  mpfr_clear(y);
  return result;
}

double factorial(int n) {
  double f = 1;
  for (int k = 2; k <= n; ++k) f *= k;
  return f;
}

double power(double x, int n) {
  double p = 1;
  for (int k = 0; k < n; ++k) p *= x;
  return p;
}

Series not_analytic() {
  return {};
}

/// t_k computed in `roundings` + k `a_step` roundings.
void bound_errors(Series& s, int order, int roundings, int a_step) {
  for (int k = 0; k <= order; ++k) {
    const auto at = static_cast<std::size_t>(k);
    s.error[at] = grow((roundings + k * a_step) * kUnit * std::fabs(s.t[at]));
  }
}

// sin and cos differ in where they start in the cycle sin, cos, -sin, -cos.
Series circular(double c, int order, int start) {
  const double sine = rounded(mpfr_sin, c), cosine = rounded(mpfr_cos, c);
  const double cycle[4] = {sine, cosine, -sine, -cosine};
  Series s;
  for (int k = 0; k <= order; ++k)
    s.t[static_cast<std::size_t>(k)] = cycle[(start + k) % 4] / factorial(k);
  bound_errors(s, order, 3, 0);
  s.rest = grow(1 / factorial(order + 1));
  return s;
}

/// A homogeneous polynomial in l0, l1, l2; [a1][a2] is the coefficient of l1^a1 l2^a2 times the
/// missing power of l0. Exact: at order 5 the coefficients stay below 4^5.
using Homogeneous = std::array<std::array<double, 6>, 6>;

Homogeneous times(const Homogeneous& p, double c0, double c1, double c2) {
  Homogeneous r{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      r[i][j] = c0 * p[i][j] + (i > 0 ? c1 * p[i - 1][j] : 0) + (j > 0 ? c2 * p[i][j - 1] : 0);
  return r;
}

}  // namespace

Series inverse_series(double c, double rho, int order) {
  const double size = std::fabs(c), nearest = shrink(size - rho);
  if (!(nearest > 0) || !std::isfinite(c)) return not_analytic();
  Series s;
  const double t = 1 / c;
  s.t[0] = t;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(order); ++k) s.t[k] = -s.t[k - 1] * t;
  bound_errors(s, order, 2, 2);
  // 1 / (c + h) less its first terms is (-h / c)^(n + 1) / (c + h).
  s.rest = grow(1 / (power(size, order + 1) * nearest));
  return s;
}

Series sqrt_series(double c, double rho, int order) {
  const double nearest = shrink(c - rho);
  if (!(nearest > 0) || !std::isfinite(c)) return not_analytic();
  Series s;
  s.t[0] = std::sqrt(c);
  double binomial = 0.5;  // of 1/2 over k + 1 after step k, in absolute value
  for (int k = 1; k <= order; ++k) {
    const auto at = static_cast<std::size_t>(k);
    s.t[at] = s.t[at - 1] * (1.5 - k) / (k * c);
    binomial *= (k - 0.5) / (k + 1);
  }
  bound_errors(s, order, 2, 4);
  // The derivatives decrease: the largest is at c - rho.
  s.rest = grow(binomial * std::sqrt(nearest) / power(nearest, order + 1));
  return s;
}

Series exp_series(double c, double rho, int order) {
  if (!std::isfinite(c) || !std::isfinite(rho)) return not_analytic();
  Series s;
  const double value = rounded(mpfr_exp, c);
  for (int k = 0; k <= order; ++k) s.t[static_cast<std::size_t>(k)] = value / factorial(k);
  bound_errors(s, order, 3, 0);
  const double furthest = c + rho + (std::fabs(c) + rho) * 0x1p-50;
  s.rest = grow(rounded(mpfr_exp, furthest, MPFR_RNDU) / factorial(order + 1));
  return s;
}

Series log_series(double c, double rho, int order) {
  const double nearest = shrink(c - rho);
  if (!(nearest > 0) || !std::isfinite(c)) return not_analytic();
  Series s;
  s.t[0] = rounded(mpfr_log, c);
  for (int k = 1; k <= order; ++k)
    s.t[static_cast<std::size_t>(k)] = (k % 2 ? 1 : -1) / (k * power(c, k));
  bound_errors(s, order, 2, 3);
  s.rest = grow(1 / ((order + 1) * power(nearest, order + 1)));
  return s;
}

Series sin_series(double c, double rho, int order) {
  return std::isfinite(c) && std::isfinite(rho) ? circular(c, order, 0) : not_analytic();
}

Series cos_series(double c, double rho, int order) {
  return std::isfinite(c) && std::isfinite(rho) ? circular(c, order, 1) : not_analytic();
}

// u = (2 l1 - l0 - l2) / 2, v = (2 l2 - l0 - l1) / 2, 1 = l0 + l1 + l2: u^i v^j as a homogeneous
// polynomial of degree Order; its coefficients over the multinomial ones.
template <int Order>
BernsteinTable<Order>::BernsteinTable() {
  const Monomials<2, Order> table;
  for (std::size_t m = 0; m < kCount; ++m) {
    Homogeneous p{};
    p[0][0] = 1;
    int left = Order;
    for (int n = table.exponents[m][0]; n > 0; --n, --left) p = times(p, -0.5, 1, -0.5);
    for (int n = table.exponents[m][1]; n > 0; --n, --left) p = times(p, -0.5, -0.5, 1);
    for (; left > 0; --left) p = times(p, 1, 1, 1);
    for (std::size_t row = 0; row < kCount; ++row) {
      const auto [a1, a2] = table.exponents[row];
      const double multinomial =
          factorial(Order) / (factorial(a1) * factorial(a2) * factorial(Order - a1 - a2));
      of[row][m] = p[a1][a2] / multinomial;
    }
  }
}

template struct BernsteinTable<3>;
template struct BernsteinTable<4>;
template struct BernsteinTable<5>;

}  // namespace crest::kernel::taylor
