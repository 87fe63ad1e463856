// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Zero on a segment: does b0 (1-t)^2 + 2 b1 t (1-t) + b2 t^2 vanish somewhere on [0, 1], its ends
// and touching included (paper 001, section 8.5, without its square root)?
//
// Yes iff b0 = 0, b0 b2 <= 0, or, with all signs reversed if b0 < 0: b1 < 0 and b1^2 >= b0 b2.
// Laws. (1) Reversing the segment or all signs, or a factor that is not 0, changes nothing.
// (2) No if b0, b1, b2 have one strict sign. (3) Yes on a part of the segment: yes on all of it.
// (4) (-1, 2, -1) and (1, -1, 1) say yes, (1, 0, 1) no.
#include <cmath>
#include <optional>

namespace crest::kernel {

/// Requires: exact numbers.
template <class T>
bool exact_segment_zero(const T& b0, const T& b1, const T& b2) {
  if (b0 == 0 || b2 == 0 || (b0 < 0) != (b2 < 0)) return true;
  return b1 != 0 && (b1 < 0) != (b0 < 0) && b1 * b1 >= b0 * b2;
}

/// For every continuous function within `slack` of the polynomial on all of [0, 1]: the same
/// answer, or none. Requires: 0 < slack. NaN and infinite coefficients leave it undecided.
inline std::optional<bool> triage_segment_zero(double b0, double b1, double b2, double slack) {
  constexpr double rounding = 1 + 0x1p-48;  // of two products and their comparison
  const double side = b0 < 0 ? -1 : 1;
  const double e0 = side * b0, e1 = side * b1, e2 = side * b2;
  if (!(e0 > slack && e0 + std::fabs(e1) + std::fabs(e2) < HUGE_VAL)) return std::nullopt;
  if (e2 < -slack) return true;
  if (!(e2 > slack)) return std::nullopt;
  // The polynomial less the slack has none of its zeros, or with it has one.
  const double low0 = e0 - slack, low1 = e1 - slack, low2 = e2 - slack;
  if (low1 >= 0 || low1 * low1 * rounding < low0 * low2) return false;
  const double high0 = e0 + slack, high1 = e1 + slack, high2 = e2 + slack;
  if (high1 < 0 && high1 * high1 > high0 * high2 * rounding) return true;
  return std::nullopt;
}

}  // namespace crest::kernel
