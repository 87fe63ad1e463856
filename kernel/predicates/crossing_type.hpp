// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Elliptic or hyperbolic at a crossing, by fourth-order quantities (paper 002, section 6.5 step 3).
//
// The crossing of edge pq lies at (|b(q)| p + |b(p)| q) / (|b(p)| + |b(q)|) (equation 4); P is
// interpolated with the same weights, so its sign is that of |b(q)| P(p) + |b(p)| P(q), both
// weights 1 when both b are zero. P = 3 m^2 + (k - l)(c - 3 k^3) with
//   blue: b = b0, k = k1, l = k2, m = b1, c = c0 (P1); red: b = b3, k = k2, l = k1, m = b2, c = c4
//   (P2).
// Negative: elliptic (maximum of k1, minimum of k2). Positive: hyperbolic. Zero: exactly flat.
//
// Laws. (1) symmetric in p and q. (2) invariant under reversal of either frame. (3) zero for planes
// and cylinders fitted exactly (m = 0, c = 3 k^3 at both ends).
// Not true: that two adjacent crossings agree (a turning point lies between them).
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// What the rule reads at an end: blue_end and red_end of geometry/monge_form.hpp fill it.
struct RidgeEndData {
  double b, k, l, m, c;
};

struct InterpolatedP {
  RidgeEndData p, q;
  /// 3 k k k: 6, c - ..: 7, times (k - l): 10, sum P: 11, times weight: 13, sum: 14.
  static constexpr int depth = 14;

  template <class T>
  static T end_p(const RidgeEndData& e) {
    const T k(e.k);
    return T(3) * T(e.m) * T(e.m) + (k - T(e.l)) * (T(e.c) - T(3) * k * k * k);
  }
  template <class T>
  T value() const {
    const bool both_zero = p.b == 0 && q.b == 0;
    const T at_p(both_zero ? 1.0 : std::fabs(q.b)), at_q(both_zero ? 1.0 : std::fabs(p.b));
    return at_p * end_p<T>(p) + at_q * end_p<T>(q);
  }
};

inline MaybeSign triage_crossing_type(const RidgeEndData& p, const RidgeEndData& q) {
  return triage(InterpolatedP{p, q});
}
MaybeSign interval_crossing_type(const RidgeEndData& p, const RidgeEndData& q);
Sign exact_crossing_type(const RidgeEndData& p, const RidgeEndData& q);
Decision crossing_type(const RidgeEndData& p, const RidgeEndData& q);

}  // namespace crest::kernel
