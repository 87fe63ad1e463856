// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Truncated Taylor polynomials: derivatives of test surfaces, exact to rounding.
#include <array>
#include <cmath>

#include "kernel/arithmetic/monomials.hpp"

namespace crest::sampling {

/// Extended precision where the machine has it, so that a form rounded to double is right to an ulp
/// or two.
using Real = long double;

using kernel::monomial_count;
using kernel::Monomials;

/// Coefficients c[i] of the monomials (no factorials), constant first, then the variables from the
/// last to the first.
template <int Variables, int Order>
struct Jet {
  static constexpr Monomials<Variables, Order> kTable{};
  std::array<Real, monomial_count(Variables, Order)> c{};

  Jet() = default;
  Jet(Real constant) { c[0] = constant; }  // NOLINT: constants mix with jets in formulas
  static Jet variable(int v, Real at) {
    Jet x(at);
    typename Monomials<Variables, Order>::Exponents e{};
    e[static_cast<std::size_t>(v)] = 1;
    x.coefficient(e) = 1;
    return x;
  }
  Real& coefficient(const typename Monomials<Variables, Order>::Exponents& e) {
    return c[static_cast<std::size_t>(kTable.find(e))];
  }
  Real coefficient(const typename Monomials<Variables, Order>::Exponents& e) const {
    return c[static_cast<std::size_t>(kTable.find(e))];
  }

  friend Jet operator+(Jet a, const Jet& b) {
    for (std::size_t i = 0; i < a.c.size(); ++i) a.c[i] += b.c[i];
    return a;
  }
  friend Jet operator-(Jet a, const Jet& b) {
    for (std::size_t i = 0; i < a.c.size(); ++i) a.c[i] -= b.c[i];
    return a;
  }
  friend Jet operator*(Real s, Jet a) {
    for (Real& x : a.c) x *= s;
    return a;
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet r;
    for (const auto& [i, j, k] : kTable.products) r.c[k] += a.c[i] * b.c[j];
    return r;
  }
  /// f(a) for f with Taylor coefficients t (no factorials) at a's constant.
  friend Jet compose(const std::array<Real, Order + 1>& t, Jet a) {
    a.c[0] = 0;
    Jet r(t[Order]);
    for (int k = Order - 1; k >= 0; --k) r = r * a + Jet(t[static_cast<std::size_t>(k)]);
    return r;
  }
  friend Jet exp(const Jet& a) {
    std::array<Real, Order + 1> t{};
    t[0] = std::exp(a.c[0]);
    for (std::size_t k = 1; k <= Order; ++k) t[k] = t[k - 1] / static_cast<Real>(k);
    return compose(t, a);
  }
  /// Requires: a positive constant.
  friend Jet sqrt(const Jet& a) {
    std::array<Real, Order + 1> t{};
    t[0] = std::sqrt(a.c[0]);
    for (std::size_t k = 1; k <= Order; ++k)  // binomial series of exponent 1/2
      t[k] = t[k - 1] * (Real(1.5) - static_cast<Real>(k)) / (static_cast<Real>(k) * a.c[0]);
    return compose(t, a);
  }
};

}  // namespace crest::sampling
