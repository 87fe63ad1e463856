// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A long double with a radius that bounds its error, in any rounding mode: for what intervals of
// doubles do not decide, before rationals.
#include <cfloat>
#include <cmath>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::certify::spline_rays {

/// Holds all x with |x - mid| <= rad.
///
/// Lemma. The result of an operation holds the exact result for all numbers that the operands hold,
/// or its radius is infinite, or one of the two is NaN: then no comparison holds. Proof. In every
/// rounding mode a result errs by at most kUnit |mid|, or by 2^-16445 where it underflows. Each
/// radius is a sum of products of non-negative terms with at most seven roundings, each a factor of
/// at least 1 - 2^-63, for which kSlack makes up, or an underflow, for which kTiny does. Quotient:
/// |a/b - a'/b'| <= (ra + |a'/b'| rb) / (|b'| - rb) for |b'| > rb.
struct LongBall {
  static_assert(LDBL_MANT_DIG >= 64 && LDBL_MIN_EXP <= -16000);
  long double mid = 0, rad = 0;
  static constexpr long double kUnit = 0x1p-63L, kSlack = 1 + 0x1p-58L, kTiny = 0x1p-16000L;

  LongBall() = default;
  LongBall(double x)  // NOLINT: numbers convert
      : mid(x), rad(std::fabs(x) < HUGE_VAL ? 0 : HUGE_VALL) {}
  LongBall(long double m, long double r) : mid(m), rad(r) {}
  /// GMP rounds towards 0: what is left of x after two doubles is below 2^-52 of the second one, or
  /// 2^-1074.
  explicit LongBall(const kernel::Rational& x) : rad(HUGE_VALL) {
    const auto high = static_cast<double>(x);
    if (!(std::fabs(high) < HUGE_VAL)) return;
    const auto low = static_cast<double>(kernel::Rational(x - kernel::Rational(high)));
    mid = static_cast<long double>(high) + low;
    if (low == 0 && x == high)
      rad = 0;
    else
      rad = (kUnit * std::fabs(mid) + 0x1p-50L * std::fabs(low)) * kSlack + 0x1p-1000L;
  }

  friend LongBall operator-(const LongBall& a) { return {-a.mid, a.rad}; }
  friend LongBall operator+(const LongBall& a, const LongBall& b) {
    const long double m = a.mid + b.mid;
    return {m, (a.rad + b.rad + kUnit * std::fabs(m)) * kSlack};
  }
  friend LongBall operator-(const LongBall& a, const LongBall& b) {
    const long double m = a.mid - b.mid;
    return {m, (a.rad + b.rad + kUnit * std::fabs(m)) * kSlack};
  }
  friend LongBall operator*(const LongBall& a, const LongBall& b) {
    const long double m = a.mid * b.mid;
    const long double r = (std::fabs(a.mid) + a.rad) * b.rad + std::fabs(b.mid) * a.rad;
    return {m, (r + kUnit * std::fabs(m)) * kSlack + kTiny};
  }
  /// Holds nothing certain (NaN) if b holds zero.
  friend LongBall operator/(const LongBall& a, const LongBall& b) {
    const long double low = (std::fabs(b.mid) - b.rad) * (1 - 0x1p-60L);
    if (!(low > 0)) return {NAN, NAN};
    const long double m = a.mid / b.mid;
    const long double r = (a.rad + (std::fabs(m) + kTiny) * b.rad + kTiny) / low;
    return {m, (r * kSlack + kUnit * std::fabs(m)) * kSlack + kTiny};
  }
};

/// Nothing if the ball holds numbers of different signs, or is undefined.
inline kernel::MaybeSign certain_sign(const LongBall& a) {
  if (a.mid > a.rad) return kernel::Sign::positive;
  if (a.mid < -a.rad) return kernel::Sign::negative;
  if (a.mid == 0 && a.rad == 0) return kernel::Sign::zero;
  return std::nullopt;
}

}  // namespace crest::certify::spline_rays
