// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Taylor models on a triangle: a polynomial in two variables with a rigorous remainder.
//
// A model of order n encloses a function f on the triangle with corners (-1/2, -1/2), (1, -1/2),
// (-1/2, 1) (barycentric coordinates: u = l1 - (l0 + l2) / 2, v = l2 - (l0 + l1) / 2; the
// centroid is the origin): |f(u, v) - p(u, v)| <= radius everywhere on it, p of degree n.
//
// Theorem. Every operation below encloses the exact result for all functions its operands enclose.
// All arithmetic is in round-to-nearest; the remainder absorbs rounding, so no rounding mode is
// switched and a model has the same bits on every machine. What is needed for the proof:
// (a) |u^i v^j| <= w(i, j) on the triangle, w = 1 if i or j is 0, else 2^-min(i, j): where both
//     are positive u + v <= 1/2, elsewhere one of them is within 1/2 of zero. w(i + k, j + l) <=
//     w(i, j) w(k, l), so with A_d = sum of w |a_ij| over i + j = d the product's terms beyond
//     degree n are at most the sum of A_d B_e over d + e > n.
// (b) A coefficient of a product is a sum of at most N terms; in floating point each term carries
//     at most N + 1 factors (1 + d), |d| <= u = 2^-53. So all coefficients together err by at most
//     1.01 (N + 1) u (sum |a|) (sum |b|), N <= 36.
// (c) A non-negative number computed from non-negative ones in at most 2^8 operations is at least
//     (1 - u)^(2^8) > 1 - 2^-44 times the exact one; grow() makes up for that, and its 2^-1000 for
//     products that underflow (each loses at most 2^-1075).
// (d) The Bernstein coefficients of u^i v^j on the triangle are averages of products of corner
//     coordinates, hence at most 1 in absolute value.
// If anything overflows the radius is infinite or NaN, and nothing is certain any more.
#include <array>
#include <cmath>

#include "kernel/arithmetic/monomials.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

/// low <= f <= high. Not finite: nothing known.
struct Range {
  double low, high;
  bool contains(double x) const { return low <= x && x <= high; }
};
/// The sign of every number in the range, or nothing.
inline MaybeSign certain_sign(const Range& r) {
  if (r.low > 0 && r.high >= r.low) return Sign::positive;
  if (r.high < 0 && r.low <= r.high) return Sign::negative;
  if (r.low == 0 && r.high == 0) return Sign::zero;
  return std::nullopt;
}

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

/// Order: 3 to 5. Coefficients in the order of Monomials<2, Order>: 1, v, u, v^2, u v, u^2, ...
template <int Order>
class TaylorModel {
 public:
  static constexpr int kCount = monomial_count(2, Order);
  static constexpr Monomials<2, Order> kTable{};
  static constexpr taylor::Weights<Order> kWeights{};

  std::array<double, kCount> c{};
  double radius = 0;

  TaylorModel() = default;
  TaylorModel(double constant) { c[0] = constant; }  // NOLINT: constants mix with models
  /// The constants within `error` of `constant`.
  static TaylorModel around(double constant, double error) {
    TaylorModel m(constant);
    m.radius = error;
    return m;
  }
  /// The function linear on the triangle with these corner values, each within `error`.
  static TaylorModel linear(double at0, double at1, double at2, double error = 0);

  /// Encloses the function's values on the triangle (Bernstein coefficients).
  Range range() const;
  /// Encloses the value at barycentric coordinates; cheap bound: |p| <= sum of |c|.
  double magnitude() const;

  TaylorModel operator-() const {
    TaylorModel r = *this;
    for (double& x : r.c) x = -x;
    return r;
  }
  friend TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) { return a.sum(b, 1); }
  friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) { return a.sum(b, -1); }
  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) { return a.product(b); }
  friend TaylorModel operator*(double s, const TaylorModel& a) { return a.scaled(s); }
  friend TaylorModel operator*(const TaylorModel& a, double s) { return a.scaled(s); }
  friend TaylorModel operator/(const TaylorModel& a, const TaylorModel& b) {
    return a * inverse(b);
  }
  friend TaylorModel inverse(const TaylorModel& a) { return a.compose(taylor::inverse_series); }
  friend TaylorModel sqrt(const TaylorModel& a) { return a.compose(taylor::sqrt_series); }
  friend TaylorModel exp(const TaylorModel& a) { return a.compose(taylor::exp_series); }
  friend TaylorModel log(const TaylorModel& a) { return a.compose(taylor::log_series); }
  friend TaylorModel sin(const TaylorModel& a) { return a.compose(taylor::sin_series); }
  friend TaylorModel cos(const TaylorModel& a) { return a.compose(taylor::cos_series); }

 private:
  static constexpr double kUnit = 0x1p-53;

  TaylorModel sum(const TaylorModel& b, double sign) const;
  TaylorModel product(const TaylorModel& b) const;
  TaylorModel scaled(double s) const;
  /// Plain sums of w |c| by degree.
  std::array<double, Order + 1> by_degree() const;
  template <class MakeSeries>
  TaylorModel compose(MakeSeries make_series) const;
};

template <int Order>
TaylorModel<Order> TaylorModel<Order>::linear(double at0, double at1, double at2, double error) {
  // l0 = (1 - u - v) 2/3 - ..: at the corners u = (-1/2, 1, -1/2), v = (-1/2, -1/2, 1).
  TaylorModel m;
  m.c[0] = (at0 + at1 + at2) / 3;
  m.c[1] = (at2 - at0) * (2.0 / 3);
  m.c[2] = (at1 - at0) * (2.0 / 3);
  const double size = std::fabs(at0) + std::fabs(at1) + std::fabs(at2);
  m.radius = grow(error + 16 * kUnit * size);
  return m;
}

template <int Order>
std::array<double, Order + 1> TaylorModel<Order>::by_degree() const {
  std::array<double, Order + 1> sums{};
  for (std::size_t m = 0; m < kCount; ++m)
    sums[static_cast<std::size_t>(kWeights.degree[m])] += kWeights.of[m] * std::fabs(c[m]);
  return sums;
}

template <int Order>
double TaylorModel<Order>::magnitude() const {
  double sum = 0;
  for (const double x : by_degree()) sum += x;
  return grow(sum + radius);
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::sum(const TaylorModel& b, double sign) const {
  TaylorModel r;
  double size = 0;
  for (std::size_t m = 0; m < kCount; ++m) {
    r.c[m] = c[m] + sign * b.c[m];
    size += std::fabs(r.c[m]);
  }
  // A rounded sum errs by at most u times itself.
  r.radius = grow(radius + b.radius + kUnit * size);
  return r;
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::scaled(double s) const {
  TaylorModel r;
  double size = 0;
  for (std::size_t m = 0; m < kCount; ++m) {
    r.c[m] = s * c[m];
    size += std::fabs(r.c[m]);
  }
  r.radius = grow(std::fabs(s) * radius + kUnit * size);
  return r;
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::product(const TaylorModel& b) const {
  TaylorModel r;
  for (const auto& [i, j, k] : kTable.products) r.c[k] += c[i] * b.c[j];
  const auto da = by_degree(), db = b.by_degree();
  double sum_a = 0, sum_b = 0, beyond = 0, tail = 0;
  for (std::size_t d = 0; d <= Order; ++d) {
    sum_a += da[d];
    sum_b += db[d];
    // tail = sum of db over degrees above Order - d.
    beyond += da[d] * tail;
    tail += db[Order - d];
  }
  // (b) with |c| in place of w |c|: w >= 2^-(Order / 2), and Order is at most 5.
  const double rounding = 1.02 * 4 * 4 * (kCount + 1) * kUnit * sum_a * sum_b;
  r.radius = grow(beyond + rounding + sum_a * b.radius + sum_b * radius + radius * b.radius);
  return r;
}

/// f(c0 + h) = t0 + h (t1 + h (...)) with h this model without its constant.
template <int Order>
template <class MakeSeries>
TaylorModel<Order> TaylorModel<Order>::compose(MakeSeries make_series) const {
  TaylorModel h = *this;
  h.c[0] = 0;
  const double rho = h.magnitude();
  const taylor::Series s = make_series(c[0], rho, Order);
  TaylorModel r = around(s.t[Order], s.error[Order]);
  for (std::size_t k = Order; k-- > 0;) r = r * h + around(s.t[k], s.error[k]);
  double power = 1;
  for (int k = 0; k <= Order; ++k) power *= rho;
  r.radius = grow(r.radius + s.rest * power);
  return r;
}

template <int Order>
Range TaylorModel<Order>::range() const {
  const auto& table = taylor::kBernstein<Order>.of;
  double low = HUGE_VAL, high = -HUGE_VAL, size = 0;
  for (const double x : c) size += std::fabs(x);
  for (const auto& row : table) {
    double b = 0;
    for (std::size_t m = 0; m < kCount; ++m) b += row[m] * c[m];
    low = std::fmin(low, b);
    high = std::fmax(high, b);
  }
  const double slack = grow(radius + (kCount + 6) * kUnit * size);
  // NaN spreads: fmin drops it, so the size is asked.
  if (!(size + slack < HUGE_VAL)) return {-HUGE_VAL, HUGE_VAL};
  return {low - slack - std::fabs(low) * 0x1p-52, high + slack + std::fabs(high) * 0x1p-52};
}

}  // namespace crest::kernel
