// SPDX-License-Identifier: GPL-3.0-or-later
// The Taylor series of elementary functions, with bounds for what they leave out.
#include "kernel/arithmetic/taylor_series.hpp"

#include "kernel/arithmetic/elementary.hpp"

namespace crest::kernel::taylor {
namespace {

constexpr double kUnit = 0x1p-53;

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

/// t_k = f^(k)(c) / k!.
void set(Series& s, int k, const Approximation& derivative) {
  const auto at = static_cast<std::size_t>(k);
  s.t[at] = derivative.value / factorial(k);
  s.error[at] = grow(derivative.error / factorial(k) + kUnit * std::fabs(s.t[at]));
}

// sin and cos differ in where they start in the cycle sin, cos, -sin, -cos.
Series circular(double c, int order, int start) {
  const auto pair = sin_cos_near(c);
  Series s;
  for (int k = 0; k <= order; ++k) {
    const auto& [value, error] = pair[static_cast<std::size_t>((start + k) % 2)];
    set(s, k, {(start + k) % 4 < 2 ? value : -value, error});
  }
  s.rest = grow(1 / factorial(order + 1));
  return s;
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
  s.rest = grow(over(1, power(size, order + 1) * nearest));
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
  // The sum of |binomial| sqrt(c) (h / c)^k over k > n, the binomials decreasing: a geometric one.
  s.rest = grow(over(binomial * std::sqrt(c), power(c, order) * nearest));
  return s;
}

Series exp_series(double c, double rho, int order) {
  if (!std::isfinite(c) || !std::isfinite(rho)) return not_analytic();
  Series s;
  const Approximation value = exp_near(c);
  for (int k = 0; k <= order; ++k) set(s, k, value);
  const Approximation furthest = exp_near(c + rho + (std::fabs(c) + rho) * 0x1p-50);
  s.rest = grow((furthest.value + furthest.error) / factorial(order + 1));
  return s;
}

Series log_series(double c, double rho, int order) {
  const double nearest = shrink(c - rho);
  if (!(nearest > 0) || !std::isfinite(c)) return not_analytic();
  Series s;
  s.t[0] = log_near(c).value;
  for (int k = 1; k <= order; ++k)
    s.t[static_cast<std::size_t>(k)] = (k % 2 ? 1 : -1) / (k * power(c, k));
  bound_errors(s, order, 2, 3);
  // The sum of (h / c)^k / k over k > n, 1 / k decreasing.
  s.rest = grow(over(1, (order + 1) * power(c, order) * nearest));
  return s;
}

Series sin_series(double c, double rho, int order) {
  return std::isfinite(c) && std::isfinite(rho) ? circular(c, order, 0) : not_analytic();
}

Series cos_series(double c, double rho, int order) {
  return std::isfinite(c) && std::isfinite(rho) ? circular(c, order, 1) : not_analytic();
}

}  // namespace crest::kernel::taylor
