// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The argument of a plane vector in plain double with a proven error bound; no libm.
#include <algorithm>
#include <array>
#include <cmath>

namespace crest::certify {

/// Divisions and a table, so one object a computation. Requires: round to nearest.
class Argument {
 public:
  /// The table comes from MPFR, each entry within half a unit in the last place.
  Argument();

  /// |operator()(y, x) - arg(x, y)| <= kError, in (-pi, pi] up to that error.
  ///
  /// Requires: finite, 2^-500 <= max(|x|, |y|) <= 2^500. u = 2^-53.
  /// With m <= M the absolute values in order, t = m / M and c = j / 16 nearest to t,
  ///   atan(m / M) = atan(c) + atan(r),  r = (m - c M) / (M + c m),  |r| <= 1/31.
  /// r: c M rounds by at most u M, the difference by u M / 31, the denominator (at least M) by
  ///   2.01 u and the quotient by u, relatively: |error| <= 1.04 u + 3.1 u / 31 <= 1.15 u. What
  ///   underflows is below 2^-1074 and M above 2^-500: lost in the slack.
  /// atan(r) = r - r z (1/3 - z/5 + z^2/7 - z^3/9) with z = r^2, alternating: the remainder is at
  ///   most |r|^11 / 11 < 0.04 u; the last subtraction rounds by u / 31, the correction term is
  ///   below |r|^3 / 3 and rounds by less than 0.001 u. Together 0.08 u.
  /// atan(c) from the table: 0.5 u; the sum is below 1: 0.5 u.          So far 2.23 u.
  /// pi/2 - a when |y| > |x|: constant 0.56 u, result below 2: u.       3.79 u.
  /// pi - a when x < 0: constant 1.11 u, result below 4: 2 u.           6.90 u.
  static constexpr double kError = 7 * 0x1p-53;

  double operator()(double y, double x) const {
    const double ax = std::fabs(x), ay = std::fabs(y);
    const double large = std::max(ax, ay), small = std::min(ax, ay);
    const auto j = static_cast<std::size_t>(small / large * 16 + 0.5);
    const double c = static_cast<double>(j) * 0.0625;
    const double r = (small - c * large) / (large + c * small);
    const double z = r * r;
    const double correction = r * z * (kThird - z * (kFifth - z * (kSeventh - z * kNinth)));
    double a = table_[j] + (r - correction);
    a = ay > ax ? kHalfPi - a : a;
    a = x < 0 ? kPi - a : a;
    return y < 0 ? -a : a;
  }

  static constexpr double kPi = 0x1.921fb54442d18p+1, kHalfPi = 0x1.921fb54442d18p+0;

 private:
  static constexpr double kThird = 1.0 / 3, kFifth = 0.2, kSeventh = 1.0 / 7, kNinth = 1.0 / 9;
  std::array<double, 17> table_;  ///< atan(j / 16)
};

}  // namespace crest::certify
