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
// (b) A coefficient of a product is a sum of at most N = 6, 9, 12 terms (order 3, 4, 5); in
// floating
//     point each term carries at most N factors (1 + d), |d| <= u = 2^-53. So all coefficients
//     together err by at most 1.01 N u (sum |a|) (sum |b|), and |a| <= 2^(Order / 2) w |a|.
// (c) A non-negative number computed from non-negative ones in at most 2^8 operations is at least
//     (1 - u)^(2^8) > 1 - 2^-44 times the exact one; grow() makes up for that, and its 2^-1000 for
//     products that underflow (each loses at most 2^-1075). A weighted coefficient that underflows
//     meets the other factor's size: kLost, 2^-1000 of either size, makes up for that.
// (d) The Bernstein coefficients of u^i v^j on the triangle are averages of products of corner
//     coordinates, hence at most 1 in absolute value.
//
// Undefined. A model is defined if its coefficients and its radius are finite. Overflow, division
// by a model that encloses zero, and functions that are not analytic at all points that their
// operand encloses, are undefined. Law: a result of an undefined operand is undefined: what is not
// finite makes the radius of every sum and product infinite or NaN (zero times infinity is NaN),
// and no series accepts a centre or a radius that is not finite.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernel/arithmetic/range.hpp"
#include "kernel/arithmetic/taylor_kernels.hpp"

namespace crest::kernel {

/// Order: 3 to 5. Coefficients in the order of Monomials<2, Order>: 1, v, u, v^2, u v, u^2, ...
template <int Order>
class TaylorModel {
 public:
  static constexpr int kCount = monomial_count(2, Order);
  static constexpr Monomials<2, Order> kTable{};
  using Kernels = taylor::Kernels<Order>;

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
  /// On the edge from corner i to corner (i + 1) % 3.
  Range range_on_edge(int i) const;
  Range at_corner(int i) const;
  /// The polynomial is a constant: nothing but c[0] and the radius.
  bool is_flat() const {
    std::uint64_t bits = 0;  // no branches: both answers are frequent
    for (std::size_t m = 1; m < kCount; ++m) bits |= std::bit_cast<std::uint64_t>(c[m]);
    return bits << 1 == 0;
  }

  friend bool is_defined(const TaylorModel& a) { return Kernels::size(a.c) + a.radius < HUGE_VAL; }

  TaylorModel operator-() const {
    TaylorModel r = *this;
    for (double& x : r.c) x = -x;
    return r;
  }
  friend TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel r;
    for (std::size_t m = 0; m < kCount; ++m) r.c[m] = a.c[m] + b.c[m];
    r.round(a.radius + b.radius);
    return r;
  }
  friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel r;
    for (std::size_t m = 0; m < kCount; ++m) r.c[m] = a.c[m] - b.c[m];
    r.round(a.radius + b.radius);
    return r;
  }
  friend TaylorModel operator*(double s, const TaylorModel& a) { return a * s; }
  friend TaylorModel operator*(const TaylorModel& a, double s) {
    TaylorModel r;
    for (std::size_t m = 0; m < kCount; ++m) r.c[m] = a.c[m] * s;
    r.round(std::fabs(s) * a.radius);
    return r;
  }
  friend TaylorModel operator/(const TaylorModel& a, double s) {
    TaylorModel r;
    for (std::size_t m = 0; m < kCount; ++m) r.c[m] = a.c[m] / s;
    r.round(a.radius / std::fabs(s) + 0 * s);  // not 0 for an s that is not finite
    return r;
  }
  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    if (a.seems_flat() && a.is_flat()) return b.times_flat(a);
    if (b.seems_flat() && b.is_flat()) return a.times_flat(b);
    TaylorModel r;
    r.c = Kernels::product(a.c, b.c);
    r.radius = grow(Kernels::left_out(a.c, a.radius, b.c, b.radius));
    return r;
  }
  /// sum += a b (see jet_tables.hpp).
  friend void add_product(TaylorModel& sum, const TaylorModel& a, const TaylorModel& b) {
    if ((a.seems_flat() && a.is_flat()) || (b.seems_flat() && b.is_flat())) {
      sum = sum + a * b;
      return;
    }
    const auto product = Kernels::product(a.c, b.c);
    const double radius = Kernels::left_out(a.c, a.radius, b.c, b.radius);
    for (std::size_t m = 0; m < kCount; ++m) sum.c[m] += product[m];
    sum.round(sum.radius + radius);
  }
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
  /// Its coefficients were rounded once each, an error of at most u times themselves, and err by
  /// `error` besides.
  void round(double error) { radius = grow(error + Kernels::kUnit * Kernels::size(c)); }
  /// Seldom true of a model that is not flat.
  bool seems_flat() const { return c[1] == 0 && c[2] == 0; }
  TaylorModel times_flat(const TaylorModel& flat) const;
  TaylorModel compose(taylor::Series (*make_series)(double c, double rho, int order)) const;
};

extern template class TaylorModel<3>;
extern template class TaylorModel<4>;
extern template class TaylorModel<5>;

}  // namespace crest::kernel
