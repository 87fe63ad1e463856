// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triage numbers: a double and the magnitude that bounds its error, with the number of roundings
// in the type, so that a formula written once as a template derives its own error bound.
#include <algorithm>
#include <cmath>

#include "kernel/arithmetic/sign.hpp"

namespace crest::certify {

/// A value computed with at most N roundings on the way from each input.
///
/// u = 2^-53, eta = 2^-1022 (the least normal number). Let x be the exact value and M the exact
/// magnitude: M = |x| for an input, Ma + Mb for a sum or difference, Ma Mb + eta for a product.
///   (1) |x| <= M,  |value - x| <= ((1+u)^N - 1) M,  magnitude >= (1-u)^2N M.
/// Sum, N = max(A, B) + 1: fl(a + b) = (a + b)(1 + d), |d| <= u, exactly so in underflow; hence
/// the error is at most ((1+u)^(N-1) - 1)(Ma + Mb) + u (1+u)^(N-1) (Ma + Mb).
/// Product, N = A + B + 1: fl(ab) = ab(1 + d) + h, |h| <= 2^-1075 = u eta; the error is at most
/// ((1+u)^(A+B) - 1) Ma Mb + u (1+u)^(A+B) Ma Mb + u eta <= ((1+u)^N - 1)(Ma Mb + eta).
/// Its magnitude rounds twice, and fl(Ma Mb) loses at most u eta to underflow, so that
/// fl(fl(Ma Mb) + eta) >= (1-u)^2 (Ma Mb + eta).
/// From (1), for N <= 1000: |value - x| <= (N + 1) u magnitude, with room for the rounding of that
/// product except in underflow, which the term eta in bound() covers. Overflow makes magnitude
/// infinite before or with value, and no comparison with an infinite bound succeeds.
template <int N>
struct Filtered {
  double value;
  double magnitude;

  double bound() const { return (N + 1) * 0x1p-53 * magnitude + 0x1p-1022; }
};

template <int A, int B>
Filtered<std::max(A, B) + 1> operator+(const Filtered<A>& a, const Filtered<B>& b) {
  return {a.value + b.value, a.magnitude + b.magnitude};
}
template <int A, int B>
Filtered<std::max(A, B) + 1> operator-(const Filtered<A>& a, const Filtered<B>& b) {
  return {a.value - b.value, a.magnitude + b.magnitude};
}
template <int A, int B>
Filtered<A + B + 1> operator*(const Filtered<A>& a, const Filtered<B>& b) {
  return {a.value * b.value, a.magnitude * b.magnitude + 0x1p-1022};
}

/// An input: exact.
inline Filtered<0> filtered(double x) {
  return {x, std::fabs(x)};
}

/// The sign of the exact value, if the bound separates it from zero.
template <int N>
kernel::MaybeSign certain_sign(const Filtered<N>& x) {
  static_assert(N <= 1000);
  const double bound = x.bound();
  if (x.value > bound) return kernel::Sign::positive;
  if (x.value < -bound) return kernel::Sign::negative;
  return std::nullopt;
}

}  // namespace crest::certify
