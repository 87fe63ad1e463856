// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Derivatives of test surfaces, exact to rounding. Meshes of them are compared to the last bit, so
// the order of every sum is fixed here: functions are composed with their Taylor series, squares
// are products of two objects (kernel::Jet halves the sums of one with itself).
#include <array>
#include <cmath>

#include "kernel/arithmetic/jet.hpp"

namespace crest::sampling {

/// Extended precision where the machine has it, so that a form rounded to double is right to an ulp
/// or two.
using Real = long double;

template <int Variables, int Order>
using Jet = kernel::Jet<Real, Variables, Order>;

template <class T>
T square(const T& x) {
  return x * T(x);
}

/// f(a) for f with Taylor coefficients t (no factorials) at a's constant.
template <int Variables, int Order>
Jet<Variables, Order> compose(const std::array<Real, Order + 1>& t, Jet<Variables, Order> a) {
  a.set(0, 0);
  auto r = Jet<Variables, Order>::constant(t[Order]);
  for (int k = Order - 1; k >= 0; --k) r = r * a + t[static_cast<std::size_t>(k)];
  return r;
}

inline Real exponential(Real x) {
  return std::exp(x);
}
template <int Variables, int Order>
Jet<Variables, Order> exponential(const Jet<Variables, Order>& a) {
  std::array<Real, Order + 1> t{exponential(a[0])};
  for (std::size_t k = 1; k <= Order; ++k) t[k] = t[k - 1] / static_cast<Real>(k);
  return compose<Variables, Order>(t, a);
}

/// The square root. Requires: a positive constant.
inline Real root(Real x) {
  return std::sqrt(x);
}
template <int Variables, int Order>
Jet<Variables, Order> root(const Jet<Variables, Order>& a) {
  std::array<Real, Order + 1> t{root(a[0])};
  for (std::size_t k = 1; k <= Order; ++k)  // binomial series of exponent 1/2
    t[k] = t[k - 1] * (Real(1.5) - static_cast<Real>(k)) / (static_cast<Real>(k) * a[0]);
  return compose<Variables, Order>(t, a);
}

}  // namespace crest::sampling
