// SPDX-License-Identifier: GPL-3.0-or-later
// The Taylor series of elementary functions, with bounds for what they leave out.
#include <mpfr.h>

#include "kernel/arithmetic/taylor_model.hpp"

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

/// Exact combinatorics: at most 5! 2^5 5! fits in an int.
long falling(int n, int k) {
  long product = 1;
  for (int i = 0; i < k; ++i) product *= n - i;
  return product;
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

// The coefficient (a0, a1, a2) of u^i v^j is the average of the products of i values of u and j of
// v over all choices of i + j different ones among a0 times corner 0, a1 times 1, a2 times 2.
template <int Order>
BernsteinTable<Order>::BernsteinTable() {
  const Monomials<2, Order> table;
  const int u2[3] = {-1, 2, -1}, v2[3] = {-1, -1, 2};  // twice the corners' coordinates
  std::size_t row = 0;
  for (int a1 = 0; a1 <= Order; ++a1)
    for (int a2 = 0; a1 + a2 <= Order; ++a2, ++row) {
      const int a[3] = {Order - a1 - a2, a1, a2};
      for (std::size_t m = 0; m < kCount; ++m) {
        const int i = table.exponents[m][0], j = table.exponents[m][1];
        long sum = 0;
        for (int i1 = 0; i1 <= i; ++i1)
          for (int i2 = 0; i1 + i2 <= i; ++i2)
            for (int j1 = 0; j1 <= j; ++j1)
              for (int j2 = 0; j1 + j2 <= j; ++j2) {
                const int us[3] = {i - i1 - i2, i1, i2}, vs[3] = {j - j1 - j2, j1, j2};
                long term = falling(i, i) * falling(j, j);
                for (int k = 0; k < 3; ++k) {
                  term /= falling(us[k], us[k]) * falling(vs[k], vs[k]);
                  term *= falling(a[k], us[k] + vs[k]);
                  for (int n = 0; n < us[k]; ++n) term *= u2[k];
                  for (int n = 0; n < vs[k]; ++n) term *= v2[k];
                }
                sum += term;
              }
        of[row][m] =
            static_cast<double>(sum) / static_cast<double>(falling(Order, i + j) << (i + j));
      }
    }
}

template struct BernsteinTable<3>;
template struct BernsteinTable<4>;
template struct BernsteinTable<5>;

}  // namespace crest::kernel::taylor
