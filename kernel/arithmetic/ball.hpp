// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A double with a radius that bounds its error: enclosures in round to nearest, without intervals'
// change of rounding mode. Beside Approximate it divides, and what it divides may carry errors.
#include <cmath>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

/// Holds all x with |x - mid| <= rad.
///
/// Theorem. The result of an operation holds the exact result for all numbers that the operands
/// hold, or rad is infinite or one of the two NaN. Proof. The result's own rounding errs by at most
/// u |mid| + 2^-1075; each radius below is a sum of products of non-negative terms with at most
/// seven roundings, each a factor of at least 1 - u, so kSlack = 1 + 16 u makes up for them, and
/// kTiny for products that underflow. Quotient: |a/b - a'/b'| <= (ra + |a'/b'| rb) / (|b'| - rb)
/// for |b'| > rb. Root: |sqrt x - sqrt x'| <= r / sqrt x' for x, x' >= 0.
struct Ball {
  double mid = 0, rad = 0;
  static constexpr double kSlack = 1 + 16 * kUnitRoundoff;
  static constexpr double kTiny = 0x1p-1022;

  Ball() = default;
  Ball(double x) : mid(x) {}  // NOLINT: numbers convert
  Ball(double m, double r) : mid(m), rad(r) {}

  friend Ball operator-(const Ball& a) { return {-a.mid, a.rad}; }
  friend Ball operator+(const Ball& a, const Ball& b) {
    const double m = a.mid + b.mid;
    return {m, (a.rad + b.rad + kUnitRoundoff * std::fabs(m)) * kSlack};
  }
  friend Ball operator-(const Ball& a, const Ball& b) {
    const double m = a.mid - b.mid;
    return {m, (a.rad + b.rad + kUnitRoundoff * std::fabs(m)) * kSlack};
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    const double m = a.mid * b.mid;
    const double r = (std::fabs(a.mid) + a.rad) * b.rad + std::fabs(b.mid) * a.rad;
    return {m, (r + kUnitRoundoff * std::fabs(m)) * kSlack + kTiny};
  }
  /// Holds nothing certain (NaN) if b holds zero.
  friend Ball operator/(const Ball& a, const Ball& b) {
    const double low = std::fabs(b.mid) - b.rad;
    if (!(low > 0)) return {std::nan(""), std::nan("")};
    const double m = a.mid / b.mid;
    const double r = (a.rad + (std::fabs(m) + kTiny) * b.rad + kTiny) / low;
    return {m, (r * kSlack + kUnitRoundoff * std::fabs(m)) * kSlack + kTiny};
  }
};

/// NaN if a holds a negative number.
inline Ball sqrt(const Ball& a) {
  if (!(a.mid > a.rad)) return {std::nan(""), std::nan("")};
  const double m = std::sqrt(a.mid);
  return {m, (a.rad / m + kUnitRoundoff * m) * Ball::kSlack};
}

/// Nothing if the ball holds numbers of different signs, or is undefined.
inline MaybeSign certain_sign(const Ball& a) {
  if (a.mid > a.rad) return Sign::positive;
  if (a.mid < -a.rad) return Sign::negative;
  if (a.mid == 0 && a.rad == 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace crest::kernel
