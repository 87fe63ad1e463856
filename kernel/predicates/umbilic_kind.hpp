// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Umbilic kind: 1-ridge (hyperbolic) or 3-ridge (elliptic), the number of real roots of the cubic
// form b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3 (paper 002, section 8.2; the index does not decide
// it).
//
// D = (b0 b3 - b1 b2)^2 - 4 (b0 b2 - b1^2)(b1 b3 - b2^2). Positive: one real root, 1-ridge.
// Negative: three, 3-ridge. Zero: a multiple root, degenerate.
//
// Laws. (1) invariant under rotation and reversal of the frame (up to rounding of the stored b).
// (2) invariant under scaling of b by any factor but zero. (3) zero for the zero form.
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

struct CubicDiscriminant {
  double b0, b1, b2, b3;
  /// Minor 2 + 1, product of two 3 + 3 + 2, times 4: 10, difference 11.
  static constexpr int depth = 11;
  template <class T>
  T value() const {
    const T p(b0), q(b1), r(b2), s(b3);
    const T mixed = p * s - q * r;
    return mixed * mixed - T(4) * ((p * r - q * q) * (q * s - r * r));
  }
};

inline MaybeSign triage_umbilic_kind(const CubicDiscriminant& c) {
  return triage(c);
}
MaybeSign interval_umbilic_kind(const CubicDiscriminant& c);
Sign exact_umbilic_kind(const CubicDiscriminant& c);
Decision umbilic_kind(const CubicDiscriminant& c);

/// Sign of (k1 - k2)(p) - (k1 - k2)(q): which vertex is closer to an umbilic, exactly.
struct GapDifference {
  double k1p, k2p, k1q, k2q;
  static constexpr int depth = 2;
  template <class T>
  T value() const {
    return (T(k1p) - T(k2p)) - (T(k1q) - T(k2q));
  }
};
Decision compare_gaps(const GapDifference& g);

}  // namespace crest::kernel
