// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Intervals by their bounds (SPEC.md, "Boxes"): for boxes of space, and as the ranges of models.
// Bounds are doubles: a result rounded to nearest and moved outwards by one, unless it is exact.
#include <algorithm>

#include "certify/second/ball.hpp"

namespace crest::recheck {

class Interval {
 public:
  Interval() = default;
  /// Throws: Undefined for a bound that is not finite.
  Interval(double lower, double upper);
  Interval(double x) : Interval(x, x) {}
  explicit Interval(const Ball& b);

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  bool is_zero() const { return lower_ == 0 && upper_ == 0; }
  /// 1, -1, or 0 if both or zero are possible.
  int sign() const { return lower_ > 0 ? 1 : upper_ < 0 ? -1 : 0; }
  /// Every number of both.
  Ball ball() const;
  /// A number about half-way.
  double middle() const { return lower_ / 2 + upper_ / 2; }
  /// Strictly between.
  bool inside(double a, double b) const { return a < lower_ && upper_ < b; }
  void add_product(const Interval& a, const Interval& b) { *this = *this + a * b; }

  friend Interval operator+(const Interval& a, const Interval& b);
  friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
  friend Interval operator*(const Interval& a, const Interval& b);
  Interval operator-() const { return {-upper_, -lower_}; }

 private:
  double lower_ = 0, upper_ = 0;
};

inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}
inline bool disjoint(const Interval& a, const Interval& b) {
  return a.upper() < b.lower() || b.upper() < a.lower();
}

Interval inverse(const Interval& x);
/// Defined for x >= 0.
Interval sqrt(const Interval& x);
Interval log(const Interval& x);
Interval exp(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
/// n >= 1; of an even n never negative.
Interval power(const Interval& x, unsigned n);
inline Interval scaled(const Interval& x, slong n, slong d = 1) {
  return x * Interval(Ball(Rational(n, static_cast<ulong>(d))));
}

}  // namespace crest::recheck
