// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Line-critical points: where a quadratic function on an edge has its extremum in the edge's
// interior (paper 003, section 3.1; exact form in certify/SPEC.md, claim 3).
//
// The derivatives at the two ends, d_a = 4m - 3a - b inwards from a and -d_b = 4m - 3b - a inwards
// from b, have the same strict sign: negative at both is a minimum, positive a maximum. A zero
// derivative at an end is no point: the edge is monotone there.
//
// Laws. (1) symmetric in the ends. (2) odd: negating the values turns minimum into maximum.
// (3) a minimum's value is below both end values, a maximum's above. (4) invariant under adding a
// constant where that is exact, and under scaling by a power of two. (5) none if m lies between a
// and b and 4 |a + b - 2m| <= |b - a| (bend against slope).
#include "kernel/predicates/critical_value.hpp"

namespace crest::kernel {

/// The inward derivative at the end a.
struct EndSlope {
  EdgeValues e;
  /// Two differences (1), one product with 4 (+ 2), one difference: derived by value<Depth>().
  static constexpr int depth = 4;
  template <class T>
  T value() const {
    return slope<T>(e.a, e.b, e.m);
  }
};

inline MaybeSign triage_end_slope(const EndSlope& x) {
  return triage(x);
}
MaybeSign interval_end_slope(const EndSlope& x);
/// Zero: the derivative vanishes in the end.
Sign exact_end_slope(const EndSlope& x);
Decision end_slope(const EndSlope& x);

/// negative: a maximum (the second derivative is negative); positive: a minimum; zero: no point.
/// stage: the later of the two ends'.
inline Decision line_critical(const EdgeValues& e) {
  const Decision a = end_slope({e});
  if (a.sign == Sign::zero) return a;
  const Decision b = end_slope({{e.b, e.a, e.m}});
  return {a.sign == b.sign ? -a.sign : Sign::zero, a.stage < b.stage ? b.stage : a.stage};
}

}  // namespace crest::kernel
