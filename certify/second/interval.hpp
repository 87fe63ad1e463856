// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Intervals by their bounds (SPEC.md, "Boxes"): for boxes of space, and as the ranges of models.
#include "certify/second/ball.hpp"

namespace crest::recheck {

class Interval {
 public:
  Interval() = default;
  /// Throws: Undefined for a bound that is not finite.
  Interval(const Float& lower, const Float& upper);
  Interval(double x) : lower_(x), upper_(x) {}
  explicit Interval(const Ball& b);

  const Float& lower() const { return lower_; }
  const Float& upper() const { return upper_; }
  bool is_zero() const { return lower_.sign() == 0 && upper_.sign() == 0; }
  /// 1, -1, or 0 if both or zero are possible.
  int sign() const { return lower_.sign() > 0 ? 1 : upper_.sign() < 0 ? -1 : 0; }
  /// Every number of both.
  Ball ball() const;
  /// A number about half-way.
  Float middle() const;
  /// Strictly between.
  bool inside(const Float& a, const Float& b) const { return a < lower_ && upper_ < b; }
  void add_product(const Interval& a, const Interval& b);

  friend Interval operator+(const Interval& a, const Interval& b);
  friend Interval operator-(const Interval& a, const Interval& b);
  friend Interval operator*(const Interval& a, const Interval& b);
  Interval operator-() const;

 private:
  Float lower_, upper_;
};

Interval hull(const Interval& a, const Interval& b);
bool disjoint(const Interval& a, const Interval& b);

Interval inverse(const Interval& x);
/// Defined for x >= 0.
Interval sqrt(const Interval& x);
Interval log(const Interval& x);
Interval exp(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
/// n >= 1; of an even n never negative.
Interval power(const Interval& x, unsigned n);
Interval scaled(const Interval& x, slong n, slong d = 1);

}  // namespace crest::recheck
