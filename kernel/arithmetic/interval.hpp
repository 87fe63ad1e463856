// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Guarded double intervals: every operation encloses the exact result.
//
// Requires: a RoundUpward object alive in the same thread around every use (one a cell, not one an
// operation: a guard costs 25 ns, an operation 2). Never call libm, Eigen or printf under it.
// A translation unit that computes with Interval is compiled with -frounding-math (Crest's kernel
// and certify folders are).
#include <CGAL/Interval_nt.h>

#include "kernel/arithmetic/sign.hpp"

namespace crest::kernel {

using Interval = CGAL::Interval_nt<false>;

/// Sets the rounding mode to upward for its lifetime and restores it.
class RoundUpward {
 public:
  RoundUpward() = default;
  RoundUpward(const RoundUpward&) = delete;
  RoundUpward& operator=(const RoundUpward&) = delete;

 private:
  CGAL::Protect_FPU_rounding<true> guard_;
};

/// The sign of every number in x, or nothing if x holds numbers of different signs.
inline MaybeSign certain_sign(const Interval& x) {
  if (x.inf() > 0) return Sign::positive;
  if (x.sup() < 0) return Sign::negative;
  if (x.inf() == 0 && x.sup() == 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace crest::kernel

// Here argument-dependent lookup finds them, as it does CGAL's square root.
namespace CGAL {

/// The whole line if x holds negative numbers. Requires: a RoundUpward.
crest::kernel::Interval strict_sqrt(const crest::kernel::Interval& x);
/// Over MPFR, under either rounding mode; a microsecond or two each.
crest::kernel::Interval exp(const crest::kernel::Interval& x);
/// The whole line if x holds negative numbers.
crest::kernel::Interval log(const crest::kernel::Interval& x);
crest::kernel::Interval sin(const crest::kernel::Interval& x);
crest::kernel::Interval cos(const crest::kernel::Interval& x);

}  // namespace CGAL
