// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Truncated Taylor polynomials: derivatives of test surfaces, exact to rounding.
#include <array>
#include <cmath>
#include <cstdint>

namespace crest::sampling {

/// Extended precision where the machine has it, so that a form rounded to double is right to an ulp
/// or two.
using Real = long double;

constexpr int monomial_count(int variables, int order) {
  int count = 1;
  for (int i = 1; i <= variables; ++i) count = count * (order + i) / i;
  return count;
}

/// The monomials of total degree <= Order by ascending degree, and their products.
template <int Variables, int Order>
struct Monomials {
  static constexpr int kCount = monomial_count(Variables, Order);
  static constexpr int kProducts = monomial_count(2 * Variables, Order);
  using Exponents = std::array<std::uint8_t, Variables>;

  std::array<Exponents, kCount> exponents{};
  std::array<std::array<std::uint8_t, 3>, kProducts> products{};

  static constexpr int degree(const Exponents& e) {
    int sum = 0;
    for (int x : e) sum += x;
    return sum;
  }
  constexpr int find(const Exponents& e) const {
    for (int i = 0; i < kCount; ++i) {
      bool same = true;
      for (std::size_t v = 0; v < Variables; ++v)
        same = same && exponents[static_cast<std::size_t>(i)][v] == e[v];
      if (same) return i;
    }
    return -1;
  }
  constexpr Monomials() {
    std::size_t next = 0;
    for (int d = 0; d <= Order; ++d) {
      Exponents e{};
      for (;;) {  // counts e up, last variable fastest
        if (degree(e) == d) exponents[next++] = e;
        int v = Variables - 1;
        while (v >= 0 && e[static_cast<std::size_t>(v)] == d) e[static_cast<std::size_t>(v--)] = 0;
        if (v < 0) break;
        ++e[static_cast<std::size_t>(v)];
      }
    }
    next = 0;
    for (std::uint8_t i = 0; i < kCount; ++i)
      for (std::uint8_t j = 0; j < kCount; ++j) {
        Exponents e = exponents[i];
        for (std::size_t v = 0; v < Variables; ++v)
          e[v] = static_cast<std::uint8_t>(e[v] + exponents[j][v]);
        if (degree(e) <= Order) products[next++] = {i, j, static_cast<std::uint8_t>(find(e))};
      }
  }
};

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
