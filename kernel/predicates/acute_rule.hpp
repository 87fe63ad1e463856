// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The acute rule (paper 002, definition 3): the maximal principal vectors at an edge's two ends are
// oriented so that they make an acute angle in space.
//
// acute_rule(d, e) is positive when the stored vectors d, e already do, negative when one of them
// has to be reversed. Paper's sentence: "Orienting an edge with the acute rule consists of choosing
// maximal principal vectors at the two vertices so that they make an acute angle in the 3D space."
// The minimal vectors follow, since the frame (d1, d2, n) is direct: one sign serves both colours.
//
// Laws. (1) symmetric: rule(d, e) = rule(e, d). (2) odd: rule(-d, e) = -rule(d, e).
// (3) rule(d, d) is positive. (4) invariant under positive scaling of d or e when d.e != 0.
// (5) never zero for non-zero vectors: exactly 90 degrees is resolved by symbolic_product.
// Not true: transitivity (the product around a triangle is negative exactly at a conflict
// triangle); rotation invariance at exactly 90 degrees; agreement with orientation by continuity
// (the paper's figures 10 and 12; measured in experiments/002-ridges).
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"
#include "kernel/predicates/symbolic.hpp"

namespace crest::kernel {

struct AcuteProduct {
  Vec3 d, e;
  /// Three products (2 each in magnitude) and two sums: 2 + 2.
  static constexpr int depth = 4;
  template <class T>
  T value() const {
    return T(d[0]) * T(e[0]) + T(d[1]) * T(e[1]) + T(d[2]) * T(e[2]);
  }
};

inline MaybeSign triage_acute_rule(const Vec3& d, const Vec3& e) {
  return triage(AcuteProduct{d, e});
}
MaybeSign interval_acute_rule(const Vec3& d, const Vec3& e);
/// Zero means exactly 90 degrees.
Sign exact_acute_rule(const Vec3& d, const Vec3& e);
inline Sign symbolic_acute_rule(const Vec3& d, const Vec3& e) {
  return symbolic_product(d, e);
}

/// Requires: d, e not zero vectors. Guarantees: never Sign::zero; stage symbolic iff d.e is zero.
Decision acute_rule(const Vec3& d, const Vec3& e);

}  // namespace crest::kernel
