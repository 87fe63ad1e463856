// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Guarded double intervals: every operation encloses the exact result.
//
// Requires: a RoundUpward object alive in the same thread around every use (one a cell, not one an
// operation: a guard costs 25 ns, an operation 2). Never call libm, Eigen or printf under it.
// A translation unit that computes with Interval is compiled with -frounding-math (Crest's kernel
// and certify folders are).
//
// Undefined. An interval is defined if its bounds are finite: then every operation that made it is
// defined at all points of its operands. Division by an interval that holds zero, log of one that
// holds numbers that are not positive, sqrt of one that holds negative numbers, and overflow, are
// undefined.
// Law: a result of an undefined operand is undefined, whatever the other operand is (zero included)
// and whatever the function (sin, exp of -infinity, division by infinity). Nothing absorbs.
// Proof, for + - *: bounds are never NaN (constructors see to that; rounded up, a sum of bounds
// never has two infinities of opposite signs, as -max is the least that overflow gives), a sum with
// an infinite bound is infinite there, and CGAL's product replaces 0 times infinity by infinity.
// Without SSE2 (WebAssembly, or CGAL_ALWAYS_ROUND_TO_NEAREST) by 0: factors are tested first.
// The rest is tested for where it is written.
//
// With CGAL_ALWAYS_ROUND_TO_NEAREST, CGAL rounds to nearest and takes the next double outwards:
// sound, and wider; RoundUpward does nothing.
#include <CGAL/Interval_nt.h>

#include <cmath>

#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

class Interval {
 public:
  Interval() = default;
  /// Undefined if x is not finite.
  Interval(double x)  // NOLINT: numbers convert
      : x_(std::fabs(x) < HUGE_VAL ? Base(x) : Base::largest()) {}
  /// Undefined unless low <= high and both are finite.
  Interval(double low, double high)
      : x_(low <= high && low > -HUGE_VAL && high < HUGE_VAL ? Base(low, high) : Base::largest()) {}
  static Interval undefined() { return Base::largest(); }

  double inf() const { return x_.inf(); }
  double sup() const { return x_.sup(); }

  Interval operator-() const { return -x_; }
  Interval& operator+=(const Interval& b) { return *this = *this + b; }
  friend Interval operator+(const Interval& a, const Interval& b) { return a.x_ + b.x_; }
  friend Interval operator-(const Interval& a, const Interval& b) { return a.x_ - b.x_; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    return kPoisonous || (is_defined(a) && is_defined(b)) ? Interval(a.x_ * b.x_) : undefined();
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    return is_defined(a) && is_defined(b) ? Interval(a.x_ / b.x_) : undefined();
  }
  // The same with a double, which CGAL's operators take in fewer steps.
  friend Interval operator+(const Interval& a, double b) {
    return is_finite(b) ? Interval(a.x_ + b) : undefined();
  }
  friend Interval operator-(const Interval& a, double b) {
    return is_finite(b) ? Interval(a.x_ - b) : undefined();
  }
  friend Interval operator*(const Interval& a, double b) {
    return is_finite(b) && (kPoisonous || is_defined(a)) ? Interval(a.x_ * b) : undefined();
  }
  friend Interval operator/(const Interval& a, double b) {
    return is_finite(b) ? Interval(a.x_ / b) : undefined();
  }
  friend Interval operator+(double a, const Interval& b) { return b + a; }
  friend Interval operator-(double a, const Interval& b) { return Interval(a) - b; }
  friend Interval operator*(double a, const Interval& b) { return b * a; }
  friend Interval operator/(double a, const Interval& b) { return Interval(a) / b; }

  friend bool is_defined(const Interval& x) { return x.inf() > -HUGE_VAL && x.sup() < HUGE_VAL; }
  friend Interval sqrt(const Interval& x);
  // Over MPFR, under either rounding mode; a microsecond or two each.
  friend Interval exp(const Interval& x);
  friend Interval log(const Interval& x);
  friend Interval sin(const Interval& x);
  friend Interval cos(const Interval& x);

 private:
  using Base = CGAL::Interval_nt<false>;
  Interval(const Base& x) : x_(x) {}  // NOLINT: results of Base's operators
  static bool is_finite(double x) { return std::fabs(x) < HUGE_VAL; }
  /// Whether zero times an infinite bound is infinite.
#ifdef CGAL_USE_SSE2
  static constexpr bool kPoisonous = true;
#else
  static constexpr bool kPoisonous = false;
#endif

  Base x_;
};

/// Sets the rounding mode to upward for its lifetime and restores it.
class RoundUpward {
 public:
  RoundUpward() = default;
  RoundUpward(const RoundUpward&) = delete;
  RoundUpward& operator=(const RoundUpward&) = delete;

 private:
  CGAL::Protect_FPU_rounding<true> guard_;
};

/// The sign of every number in x, or nothing if x holds numbers of different signs or is undefined.
inline MaybeSign certain_sign(const Interval& x) {
  if (x.inf() > 0 && x.sup() < HUGE_VAL) return Sign::positive;
  if (x.sup() < 0 && x.inf() > -HUGE_VAL) return Sign::negative;
  if (x.inf() == 0 && x.sup() == 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace crest::kernel
