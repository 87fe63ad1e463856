// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lower and upper bounds of a function: what Taylor models give, under any rounding mode.
#include <cmath>
#include <optional>

#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

/// low <= f <= high. Not finite: nothing known.
struct Range {
  double low, high;
  bool contains(double x) const { return low <= x && x <= high; }
};
/// The sign of every number in the range, or nothing.
inline MaybeSign certain_sign(const Range& r) {
  if (r.low > 0 && r.high >= r.low && r.high < HUGE_VAL) return Sign::positive;
  if (r.high < 0 && r.low <= r.high && r.low > -HUGE_VAL) return Sign::negative;
  if (r.low == 0 && r.high == 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace crest::kernel
