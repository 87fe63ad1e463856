// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A long double with a radius that bounds its error, in any rounding mode: for what intervals of
// doubles do not decide, before rationals.
#include <cmath>
#include <limits>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::certify::spline_rays {

/// Holds all x with |x - mid| <= rad.
///
/// Lemma. The result of an operation holds the exact result for all numbers that the operands hold,
/// or its radius is infinite, or one of the two is NaN: then no comparison holds. Proof, for p
/// digits and u = kUnit = 2^(1 - p). In every rounding mode a result errs by at most u |mid|, or by
/// the least positive number, u min(), where a product or quotient underflows; sums that would are
/// exact. Each radius is a sum of products of non-negative terms with at most seven roundings, each
/// a factor of at least 1 - u, for which kSlack = 1 + 32 u makes up, or an underflow, for which
/// kTiny does; in sums the only one is of u |mid|, which stays at least the last place of mid.
/// Quotient: |a/b - a'/b'| <= (ra + |a'/b'| rb) / (|b'| - rb) for |b'| > rb.
///
/// All it needs of `long double` is one of IEEE 754's formats: 53 digits (Visual C++, Apple's ARM),
/// 64 (x86), 113 (ARM on Linux, WebAssembly). A pair of doubles (PowerPC) is none.
struct LongBall {
  using Limits = std::numeric_limits<long double>;
  static_assert(Limits::is_iec559 && Limits::radix == 2);
  static_assert(Limits::digits == 53 || Limits::digits == 64 || Limits::digits == 113);
  long double mid = 0, rad = 0;
  static constexpr long double kUnit = Limits::epsilon(), kSlack = 1 + 32 * kUnit,
                               kTiny = Limits::min();

  LongBall() = default;
  LongBall(double x)  // NOLINT: numbers convert
      : mid(x), rad(std::fabs(x) < HUGE_VAL ? 0 : HUGE_VALL) {}
  /// What overflows is the largest number in some rounding modes.
  LongBall(long double m, long double r)
      : mid(m), rad(std::fabs(m) < Limits::max() && r < Limits::max() ? r : HUGE_VALL) {}
  /// Nothing is taken for granted of conversions to doubles: rationals tell whether what two
  /// doubles leave of x is below what is expected, or the radius is infinite.
  explicit LongBall(const kernel::Rational& x) : rad(HUGE_VALL) {
    const auto high = static_cast<double>(x);
    if (!(std::fabs(high) < HUGE_VAL)) return;
    const auto rest = kernel::Rational(x - kernel::Rational(high));
    const auto low = static_cast<double>(rest);
    if (!(std::fabs(low) < HUGE_VAL)) return;
    mid = static_cast<long double>(high) + low;
    const double left = rest == 0 ? 0 : 0x1p-50 * std::fabs(low) + 0x1p-1000;
    if (abs(kernel::Rational(rest - kernel::Rational(low))) <= kernel::Rational(left))
      rad = rest == 0 ? 0 : (kUnit * std::fabs(mid) + left) * kSlack + kTiny;
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
    const long double low = (std::fabs(b.mid) - b.rad) * (1 - 8 * kUnit);
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
