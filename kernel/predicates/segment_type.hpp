// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Elliptic or hyperbolic on a triangle, by third-order quantities: the det rule (paper 002,
// section 5.3).
//
// In a triangle (v1, v2, v3), counter-clockwise, crossed on v1v2 in r1 and on v1v3 in r2, with N
// its normal, a principal vector u at v1 points to the segment's far side as det(u, r2 - r1, N) >
// 0, so the extremality for a vector pointing towards the segment has the sign
//   at v1:  beta(v1) sgn det(u(v1), r2 - r1, N),   at v2, v3:  -beta sgn det(u, r2 - r1, N);
// "the sign appearing at least at two vertices" decides: positive is a maximum.
// The segment direction is kept free of division by multiplying with both weights' sums.
//
// Laws. (1) odd in u with beta fixed, so the vote is invariant under frame reversal (beta is odd
// too). (2) invariant under cyclic renaming (the apex v1 is determined by the crossed sides). (3)
// zero iff u lies in the plane spanned by the segment and N.
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// A triangle with its apex first and the extremalities of one colour.
struct CrossedTriangle {
  Vec3 v1, v2, v3;
  double b1, b2, b3;  ///< b0 (or b3) at the three vertices
};

/// det(u, r2 - r1, (v2 - v1) x (v3 - v1)) up to a positive factor; u = d1, or n x d1 for red.
struct SegmentSide {
  const CrossedTriangle& t;
  Vec3 d1, n;
  bool red;
  /// Derived by running value<Depth>() (tests/kernel).
  static constexpr int depth = 23;

  template <class T>
  Vector3<T> vector() const {
    return red ? cross(lift<T>(n), lift<T>(d1)) : lift<T>(d1);
  }
  template <class T>
  T value() const {
    const Vector3<T> v1 = lift<T>(t.v1), e2 = lift<T>(t.v2) - v1, e3 = lift<T>(t.v3) - v1;
    // r = v1 + (|b1| / (|b1| + |b_far|)) e, weights 1, 1 when both b are zero.
    const bool zero2 = t.b1 == 0 && t.b2 == 0, zero3 = t.b1 == 0 && t.b3 == 0;
    const T near2(zero2 ? 1.0 : std::fabs(t.b1)), near3(zero3 ? 1.0 : std::fabs(t.b1));
    const T sum2 = near2 + T(zero2 ? 1.0 : std::fabs(t.b2));
    const T sum3 = near3 + T(zero3 ? 1.0 : std::fabs(t.b3));
    const Vector3<T> u = vector<T>();
    Vector3<T> x;  // (r2 - r1) sum2 sum3
    for (std::size_t k = 0; k < 3; ++k) x[k] = sum2 * near3 * e3[k] - sum3 * near2 * e2[k];
    // (u x x).(e2 x e3)
    return dot(u, e2) * dot(x, e3) - dot(u, e3) * dot(x, e2);
  }
};

inline MaybeSign triage_segment_side(const SegmentSide& s) {
  return triage(s);
}
MaybeSign interval_segment_side(const SegmentSide& s);
Sign exact_segment_side(const SegmentSide& s);
Decision segment_side(const SegmentSide& s);

}  // namespace crest::kernel
