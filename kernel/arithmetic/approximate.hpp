// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A double with the magnitude that bounds its error: the number type of every triage stage.
#include <algorithm>
#include <cmath>

#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

/// u = 2^-53, half the distance from 1 to the next double.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// value: the formula in plain double. magnitude: the same formula with every term made positive.
///
/// Theorem. Let k be the formula's depth (see Depth). Then
///   |value - exact| <= (k + 2) u magnitude   for k <= 1000, unless magnitude overflows.
/// Proof. Without underflow every leaf term of the expanded formula is multiplied by at most k
/// factors (1 + d), |d| <= u: an addition adds one factor to the larger count of its operands, a
/// product one to their sum. So |value - exact| <= ((1 + u)^k - 1) X with X the exact magnitude,
/// and the computed magnitude is at least (1 - u)^k X; the quotient is below (k + 1) u, and the
/// product (k + 2) u magnitude absorbs its own rounding. A product that underflows errs by at most
/// 2^-1075 = u 2^-1022 more, which the term kTiny added to its magnitude carries through the rest
/// of the formula. Sums do not underflow. If something overflows, magnitude is infinite and the
/// comparison |value| > bound is false: not decided.
struct Approximate {
  double value = 0, magnitude = 0;
  static constexpr double kTiny = 0x1p-1022;

  Approximate() = default;
  Approximate(double x) : value(x), magnitude(std::fabs(x)) {}  // NOLINT: numbers convert
  Approximate(double v, double m) : value(v), magnitude(m) {}

  friend Approximate operator+(const Approximate& a, const Approximate& b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
  }
  friend Approximate operator-(const Approximate& a, const Approximate& b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
  }
  friend Approximate operator*(const Approximate& a, const Approximate& b) {
    return {a.value * b.value, a.magnitude * b.magnitude + kTiny};
  }
};

/// The sign of the exact formula, if the error bound of depth k separates it from zero.
inline MaybeSign certain_sign(const Approximate& x, int depth) {
  const double bound = (depth + 2) * kUnitRoundoff * x.magnitude;
  if (x.value > bound) return Sign::positive;
  if (x.value < -bound) return Sign::negative;
  return std::nullopt;
}

/// Counts the rounding factors of a formula: run a predicate's template on it to derive its depth.
/// A product rounds the value once; its magnitude rounds twice (product and + kTiny).
struct Depth {
  int count = 0;
  Depth() = default;
  Depth(double) {}  // NOLINT: inputs and small constants are exact
  explicit Depth(int c, bool) : count(c) {}
  friend Depth operator+(Depth a, Depth b) { return Depth(std::max(a.count, b.count) + 1, true); }
  friend Depth operator-(Depth a, Depth b) { return a + b; }
  friend Depth operator*(Depth a, Depth b) { return Depth(a.count + b.count + 2, true); }
};

}  // namespace crest::kernel
