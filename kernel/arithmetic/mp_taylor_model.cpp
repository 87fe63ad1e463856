// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/arithmetic/mp_taylor_model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {
namespace {

bool is_zero(const MpInterval& x) {
  return certain_sign(x) == Sign::zero;
}

Rational factorial(int n) {
  Rational f = 1;
  for (int k = 2; k <= n; ++k) f *= k;
  return f;
}

/// Homogeneous in l0, l1, l2: [a1][a2] is the coefficient of l1^a1 l2^a2 and the missing power of
/// l0.
using Homogeneous = std::array<std::array<Rational, 6>, 6>;

Homogeneous times(const Homogeneous& p, const Rational& c0, const Rational& c1,
                  const Rational& c2) {
  Homogeneous r;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      r[i][j] = c0 * p[i][j];
      if (i > 0) r[i][j] += c1 * p[i - 1][j];
      if (j > 0) r[i][j] += c2 * p[i][j - 1];
    }
  return r;
}

/// [row][m]: the Bernstein coefficient of l0^a0 l1^a1 l2^a2 of the monomial m, (a1, a2) the
/// exponents of the monomial `row`. With u = l1 - (l0 + l2) / 2, v = l2 - (l0 + l1) / 2 and
/// 1 = l0 + l1 + l2 a monomial is homogeneous of degree Order; its coefficients are divided by the
/// multinomial ones.
template <int Order>
std::vector<std::vector<MpInterval>> bernstein_table(mpfr_prec_t bits) {
  const Monomials<2, Order> monomials;
  std::vector<std::vector<MpInterval>> rows(monomials.kCount);
  for (const auto& [i, j] : monomials.exponents) {
    Homogeneous p;
    p[0][0] = 1;
    for (int n = 0; n < i; ++n) p = times(p, Rational(-1, 2), 1, Rational(-1, 2));
    for (int n = 0; n < j; ++n) p = times(p, Rational(-1, 2), Rational(-1, 2), 1);
    for (int n = i + j; n < Order; ++n) p = times(p, 1, 1, 1);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const auto [a1, a2] = monomials.exponents[row];
      const Rational multinomial =
          factorial(Order) / (factorial(a1) * factorial(a2) * factorial(Order - a1 - a2));
      rows[row].push_back(MpInterval::from(p[a1][a2] / multinomial, bits));
    }
  }
  return rows;
}

}  // namespace

template <int Order>
MpTaylorModel<Order>::MpTaylorModel(const MpTaylorModel& other) = default;

template <int Order>
MpTaylorModel<Order>::MpTaylorModel(MpTaylorModel&& other) noexcept = default;

template <int Order>
MpTaylorModel<Order>& MpTaylorModel<Order>::operator=(const MpTaylorModel& other) = default;

template <int Order>
MpTaylorModel<Order>& MpTaylorModel<Order>::operator=(MpTaylorModel&& other) noexcept = default;

template <int Order>
MpTaylorModel<Order>::~MpTaylorModel() = default;

template <int Order>
MpTaylorModel<Order>::MpTaylorModel(const MpInterval& constant) : MpTaylorModel() {
  c[0] = constant;
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::around(double constant, double error) {
  MpTaylorModel m(constant);
  m.remainder = MpInterval::between(-error, error, kBits);
  return m;
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::undefined() {
  return MpTaylorModel(MpInterval::undefined(kBits));
}

template <int Order>
bool MpTaylorModel<Order>::all_defined() const {
  return is_defined(remainder) &&
         std::all_of(c.begin(), c.end(), [](const MpInterval& x) { return is_defined(x); });
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::linear(double at0, double at1, double at2,
                                                  double error) {
  // At the corners u = (-1/2, 1, -1/2), v = (-1/2, -1/2, 1).
  const MpInterval f0(at0, kBits), f1(at1, kBits), f2(at2, kBits);
  MpTaylorModel m = around(0, error);
  m.c[0] = (f0 + f1 + f2) / 3;
  m.c[1] = (f2 - f0) * 2 / 3;
  m.c[2] = (f1 - f0) * 2 / 3;
  return m;
}

template <int Order>
MpInterval MpTaylorModel<Order>::polynomial_range(unsigned without) const {
  static const auto table = bernstein_table<Order>(kBits);
  bool first = true;
  MpInterval range(kBits);
  for (std::size_t row = 0; row < kCount; ++row) {
    const int a1 = kTable.exponents[row][0], a2 = kTable.exponents[row][1];
    if (((without & 1) != 0 && a1 + a2 < Order) || ((without & 2) != 0 && a1 > 0) ||
        ((without & 4) != 0 && a2 > 0))
      continue;
    MpInterval b = c[0];  // Bernstein coefficients of 1 are 1
    for (std::size_t m = 1; m < kCount; ++m)
      if (!is_zero(c[m])) b = b + c[m] * table[row][m];
    range = first ? b : MpInterval::hull(range, b);
    first = false;
  }
  return range;
}

template <int Order>
Range MpTaylorModel<Order>::range_without(unsigned corners) const {
  const MpInterval values = polynomial_range(corners) + remainder;
  if (!all_defined()) return {-HUGE_VAL, HUGE_VAL};
  return {values.lower(), values.upper()};
}

template <int Order>
Range MpTaylorModel<Order>::range() const {
  return range_without(0);
}

template <int Order>
Range MpTaylorModel<Order>::range_on_edge(int i) const {
  return range_without(1u << (i + 2) % 3);
}

template <int Order>
Range MpTaylorModel<Order>::at_corner(int i) const {
  return range_without(7u & ~(1u << i));
}

template <int Order>
bool MpTaylorModel<Order>::is_flat() const {
  return std::all_of(c.begin() + 1, c.end(), is_zero);
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::operator-() const {
  MpTaylorModel r;
  for (std::size_t m = 0; m < kCount; ++m) r.c[m] = -c[m];
  r.remainder = -remainder;
  return r;
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::plus(const MpTaylorModel& b) const {
  MpTaylorModel r;
  for (std::size_t m = 0; m < kCount; ++m) r.c[m] = c[m] + b.c[m];
  r.remainder = remainder + b.remainder;
  return r;
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::scaled(double s) const {
  MpTaylorModel r;
  for (std::size_t m = 0; m < kCount; ++m) r.c[m] = c[m] * s;
  r.remainder = remainder * s;
  return r;
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::divided(double s) const {
  MpTaylorModel r;
  for (std::size_t m = 0; m < kCount; ++m) r.c[m] = c[m] / s;
  r.remainder = remainder / s;
  return r;
}

template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::times(const MpTaylorModel& b) const {
  // Zeros are skipped below.
  if (!all_defined() || !b.all_defined()) return undefined();
  MpTaylorModel r;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (is_zero(c[i])) continue;
    for (std::size_t j = 0; j < kCount; ++j) {
      if (is_zero(b.c[j])) continue;
      const MpInterval term = c[i] * b.c[j];
      const int up = kTable.exponents[i][0] + kTable.exponents[j][0];
      const int vp = kTable.exponents[i][1] + kTable.exponents[j][1];
      if (up + vp > Order) {
        const double w = taylor::weight(up, vp);
        r.remainder = r.remainder + term * MpInterval::between(-w, w, kBits);
      } else {
        const auto k = static_cast<std::size_t>(
            kTable.find({static_cast<std::uint8_t>(up), static_cast<std::uint8_t>(vp)}));
        r.c[k] = r.c[k] + term;
      }
    }
  }
  if (!is_zero(b.remainder)) r.remainder = r.remainder + polynomial_range() * b.remainder;
  if (!is_zero(remainder))
    r.remainder = r.remainder + b.polynomial_range() * remainder + remainder * b.remainder;
  return r;
}

template <int Order>
auto MpTaylorModel<Order>::series(Function f, const MpInterval& x) -> Coefficients {
  Coefficients t;
  const MpInterval one(1.0, kBits);
  const MpInterval sine = sin(x), cosine = cos(x);
  const MpInterval cycle[4] = {sine, cosine, -sine, -cosine};
  for (std::size_t k = 0; k < t.size(); ++k) {
    const auto n = static_cast<double>(k);
    const MpInterval factor = one / MpInterval::from(factorial(static_cast<int>(k)), kBits);
    switch (f) {
      case Function::inverse:  // (-1)^k / x^(k + 1)
        t[k] = k == 0 ? one / x : -t[k - 1] / x;
        break;
      case Function::sqrt:  // the binomial series of exponent 1/2
        t[k] = k == 0 ? sqrt(x) : t[k - 1] * (1.5 - n) / (x * n);
        break;
      case Function::exp:
        t[k] = exp(x) * factor;
        break;
      case Function::log:  // (-1)^(k - 1) / (k x^k)
        t[k] = k == 0 ? log(x) : k == 1 ? one / x : t[k - 1] * (1 - n) / (x * n);
        break;
      case Function::sin:
        t[k] = cycle[k % 4] * factor;
        break;
      case Function::cos:
        t[k] = cycle[(k + 1) % 4] * factor;
        break;
    }
  }
  return t;
}

// Taylor's formula with h = f - c: sum t_k(c) h^k + t_(n + 1)(between) h^(n + 1).
template <int Order>
MpTaylorModel<Order> MpTaylorModel<Order>::compose(Function f) const {
  if (!all_defined()) return undefined();
  MpTaylorModel h = *this;
  h.c[0] = MpInterval(0.0, kBits);
  const MpInterval size = h.polynomial_range() + h.remainder;
  const MpInterval between = c[0] + MpInterval::hull(size, h.c[0]);
  const bool positive = certain_sign(between) == Sign::positive;
  if ((f == Function::sqrt || f == Function::log) && !positive) return undefined();
  if (f == Function::inverse && between.contains_zero()) return undefined();
  const Coefficients t = series(f, c[0]);
  MpTaylorModel r(t[Order]);
  for (std::size_t k = Order; k-- > 0;) r = r * h + MpTaylorModel(t[k]);
  MpInterval rest = series(f, between)[Order + 1];
  for (int k = 0; k <= Order; ++k) rest = rest * size;
  r.remainder = r.remainder + rest;
  return r;
}

template class MpTaylorModel<3>;
template class MpTaylorModel<4>;
template class MpTaylorModel<5>;

}  // namespace crest::kernel
