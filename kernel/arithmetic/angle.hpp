// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Arguments of points of the plane with a proven error, without libm.
#include <cmath>

namespace crest::kernel {

inline constexpr double kPi = 0x1.921fb54442d18p+1;  // pi rounded; off by less than 2^-52

/// Bound of |argument(y, x) - true argument of the point (x, y)|.
/// atan(t) for |t| <= tan(pi/8) < 0.4143 by its alternating series up to t^19: the remainder is
/// below the next term, 0.4143^21 / 21 < 4.5e-10. The quotients, the Horner steps and the rounded
/// multiples of pi add less than 40 u.
inline constexpr double kArgumentError = 5e-10;

/// In [-pi, pi]; 0 for the origin. Requires: finite arguments whose larger absolute value is a
/// normal number.
inline double argument(double y, double x) {
  const double ax = std::fabs(x), ay = std::fabs(y);
  const double larger = ax > ay ? ax : ay, smaller = ax > ay ? ay : ax;
  if (larger == 0) return 0;
  double t = smaller / larger, base = 0;
  if (t > 0.41421356) {
    t = (smaller - larger) / (smaller + larger);
    base = kPi / 4;
  }
  const double s = t * t;
  double series = 0;
  for (int n = 19; n >= 1; n -= 2) series = 1.0 / n - s * series;
  double angle = base + t * series;
  if (ay > ax) angle = kPi / 2 - angle;
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace crest::kernel
