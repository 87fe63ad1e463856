// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Intervals on MPFR with directed rounding: every operation encloses the exact results for all
// points of its operands. Independent of the processor's rounding mode, of FMA and of flags.
//
// Precision is a run-time property of each interval, in bits; a result has the larger precision of
// its operands.
//
// Undefined. An interval is defined if its bounds are finite; every other one is the whole line. So
// are division by an interval that holds zero, log of one that holds numbers that are not positive,
// sqrt of one that holds negative numbers, and overflow.
// Law: a result of an undefined operand is undefined, zero times it and sin of it included.
#include <mpfr.h>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

class MpInterval {
 public:
  /// The point zero.
  explicit MpInterval(mpfr_prec_t bits = 64);
  /// The point x (exact if bits >= 53). Undefined if x is not finite.
  MpInterval(double x, mpfr_prec_t bits);
  MpInterval(const MpInterval& other);
  MpInterval(MpInterval&& other) noexcept;
  MpInterval& operator=(MpInterval other) noexcept;
  ~MpInterval();

  /// An enclosure one unit in the last place wide.
  static MpInterval from(const Rational& x, mpfr_prec_t bits);
  /// All x with low <= x <= high; undefined unless low <= high and both are finite.
  static MpInterval between(double low, double high, mpfr_prec_t bits);
  /// Undefined if a or b is.
  static MpInterval hull(const MpInterval& a, const MpInterval& b);
  static MpInterval pi(mpfr_prec_t bits);
  static MpInterval undefined(mpfr_prec_t bits);

  mpfr_prec_t precision() const { return mpfr_get_prec(low_); }
  /// Doubles rounded outward.
  double lower() const { return mpfr_get_d(low_, MPFR_RNDD); }
  double upper() const { return mpfr_get_d(high_, MPFR_RNDU); }
  /// An upper bound of the width.
  double width() const;
  bool contains(const Rational& x) const;
  bool contains_zero() const;

  MpInterval operator-() const;
  friend MpInterval operator+(const MpInterval& a, const MpInterval& b);
  friend MpInterval operator-(const MpInterval& a, const MpInterval& b);
  friend MpInterval operator*(const MpInterval& a, const MpInterval& b);
  friend MpInterval operator/(const MpInterval& a, const MpInterval& b);
  friend MpInterval operator+(const MpInterval& a, double b);
  friend MpInterval operator-(const MpInterval& a, double b);
  friend MpInterval operator*(const MpInterval& a, double b);
  friend MpInterval operator/(const MpInterval& a, double b);
  friend MpInterval sqrt(const MpInterval& a);
  friend MpInterval exp(const MpInterval& a);
  friend MpInterval log(const MpInterval& a);
  friend MpInterval sin(const MpInterval& a);
  friend MpInterval cos(const MpInterval& a);
  /// The arguments of all points (x, y), modulo 2 pi: continuous across the negative x-axis, where
  /// the result holds pi and may exceed it. A box that holds the origin gives an interval that
  /// encloses [-pi, pi].
  friend MpInterval atan2(const MpInterval& y, const MpInterval& x);
  friend bool is_defined(const MpInterval& a) {
    return mpfr_number_p(a.low_) != 0 && mpfr_number_p(a.high_) != 0;
  }
  /// The sign of every point of a, or nothing if a holds points of different signs or is undefined.
  friend MaybeSign certain_sign(const MpInterval& a);

 private:
  /// Makes the whole line of what is not finite.
  void settle();
  /// f over a; f is monotone between `shift` + whole multiples of pi, where it is 1 and -1 in
  /// turns, 1 at `shift`.
  static MpInterval wave(const MpInterval& a, int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t),
                         double shift);
  mpfr_t low_;
  mpfr_t high_;
};

/// The number x with the precision of `like` (see jet_tables.hpp).
inline MpInterval number_like(double x, const MpInterval* like) {
  return MpInterval(x, like != nullptr ? like->precision() : mpfr_prec_t{64});
}

}  // namespace crest::kernel
