// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A sum of two doubles with a radius: a ball with twice a double's digits.
#include <cmath>

#include "kernel/arithmetic/ball.hpp"

namespace crest::certify::curves {

using kernel::Ball;

/// Holds all x with |x - hi - lo| <= rad; |lo| <= 2^-52 |hi|.
///
/// The middles are Dekker's and Knuth's sums and products of pairs. Their relative errors are at
/// most 3 u^2 and 10 u^2 (Joldes, Muller, Popescu, Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic, 2017), below kUnit, where nothing underflows; what
/// does is below kTiny. Radii as for Ball. Overflow makes a radius or a middle infinite or not a
/// number, and nothing is certain of those.
struct WideBall {
  double hi = 0, lo = 0, rad = 0;
  static constexpr double kUnit = 0x1p-100, kSlack = 1 + 0x1p-48, kTiny = 0x1p-960;

  WideBall() = default;
  WideBall(double x) : hi(x) {}  // NOLINT: numbers convert
  WideBall(double high, double low, double r) : hi(high), lo(low), rad(r) {}
  explicit WideBall(const Ball& x) : hi(x.mid), rad(x.rad) {}
  explicit operator Ball() const { return {hi, (rad + std::fabs(lo)) * kSlack}; }

  /// The middle alone.
  WideBall middle() const { return {hi, lo, 0}; }

  friend WideBall operator-(const WideBall& a) { return {-a.hi, -a.lo, a.rad}; }
  friend WideBall operator+(const WideBall& a, const WideBall& b) {
    const auto [s, e] = two_sum(a.hi, b.hi);
    const auto [t, f] = two_sum(a.lo, b.lo);
    const auto [v, w] = fast_two_sum(s, e + t);
    const auto [hi, lo] = fast_two_sum(v, f + w);
    return {hi, lo, (a.rad + b.rad + kUnit * std::fabs(hi)) * kSlack};
  }
  friend WideBall operator-(const WideBall& a, const WideBall& b) { return a + -b; }
  friend WideBall operator*(const WideBall& a, const WideBall& b) {
    const auto [p, e] = two_product(a.hi, b.hi);
    const auto [hi, lo] = fast_two_sum(p, e + (a.hi * b.lo + a.lo * b.hi));
    const double r = (std::fabs(a.hi) + a.rad) * b.rad + std::fabs(b.hi) * a.rad;
    return {hi, lo, (r + kUnit * std::fabs(hi)) * kSlack + kTiny};
  }
  /// Whatever the quotient's middle m is, |a' / b' - m| = |a' - m b'| / |b'|.
  friend WideBall operator/(const WideBall& a, const WideBall& b) {
    const double low = std::fabs(b.hi) * (1 - 0x1p-50) - b.rad;
    if (!(low > 0)) return {std::nan(""), 0, std::nan("")};
    const double first = a.hi / b.hi;
    const double second = (a.middle() - WideBall(first) * b.middle()).hi / b.hi;
    const auto [hi, lo] = two_sum(first, second);
    const WideBall rest = a - WideBall(hi, lo, 0) * b;
    return {hi, lo, (std::fabs(rest.hi) * kSlack + rest.rad) / low * kSlack + kTiny};
  }

 private:
  struct Pair {
    double high, low;
  };
  static Pair two_sum(double a, double b) {
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  /// Requires: |a| >= |b|, or a = 0.
  static Pair fast_two_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static Pair split(double a) {
    const double c = 0x1.0000002p27 * a, h = c - (c - a);
    return {h, a - h};
  }
  static Pair two_product(double a, double b) {
    const double p = a * b;
    const auto [ah, al] = split(a);
    const auto [bh, bl] = split(b);
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
  }
};

inline int sign_of(const WideBall& x) {
  return x.hi * (1 - 0x1p-50) > x.rad ? 1 : x.hi * (1 - 0x1p-50) < -x.rad ? -1 : 0;
}

}  // namespace crest::certify::curves
