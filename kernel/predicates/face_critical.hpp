// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Face-critical points: whether the centre of a quadratic function's conics lies strictly inside
// the triangle, and what it is there (paper 003, section 3.1, H = 4AC - B^2; exact form in
// certify/SPEC.md, claim 3).
//
// centre_side of a side is H times the centre's barycentric coordinate that vanishes on the side,
// up to a positive factor common to the three; they sum to H. So the centre is strictly inside iff
// the three signs are equal and not zero, and then they are H's sign.
//
// Laws. (1) invariant under renaming the corners. (2) centre_side and H are even: negating the
// values keeps them. (3) where H is zero the answer is none, also for a line of critical points.
// (4) a point inside implies a line-critical point on some side (the paper's <1,0> is impossible).
// (5) invariant under adding a constant where that is exact, and under scaling by powers of two.
#include "kernel/predicates/critical_value.hpp"

namespace crest::kernel {

/// For the side c0 c1: g q - h p.
struct CentreSide {
  FaceValues f;
  /// g, h: 4; p, q: 2; product 4 + 2 + 2, difference + 1: derived by value<Depth>().
  static constexpr int depth = 9;
  template <class T>
  T value() const {
    const T g = slope<T>(f.corner[0], f.corner[1], f.side[0]);
    const T h = slope<T>(f.corner[0], f.corner[2], f.side[2]);
    const T p = bend<T>(f.corner[0], f.corner[1], f.side[0]);
    const T q = (T(f.corner[0]) - T(f.side[0])) + (T(f.side[1]) - T(f.side[2]));
    return g * q - h * p;
  }
};

/// p r - q^2.
struct Hessian {
  FaceValues f;
  /// p, q, r: 2; product 2 + 2 + 2, difference + 1: derived by value<Depth>().
  static constexpr int depth = 7;
  template <class T>
  T value() const {
    const FaceDerivatives<T> d(f);
    return d.p * d.r - d.q * d.q;
  }
};

inline MaybeSign triage_centre_side(const CentreSide& x) {
  return triage(x);
}
MaybeSign interval_centre_side(const CentreSide& x);
/// Zero: the centre, or for H = 0 the axes' direction, lies on the side's line or nowhere.
Sign exact_centre_side(const CentreSide& x);
Decision centre_side(const CentreSide& x);

inline MaybeSign triage_hessian(const Hessian& x) {
  return triage(x);
}
MaybeSign interval_hessian(const Hessian& x);
/// Positive: ellipses, negative: hyperbolas, zero: parabolas, parallel lines or a linear function.
Sign exact_hessian(const Hessian& x);
Decision hessian(const Hessian& x);

/// zero: no point strictly inside; positive: an extremum inside, negative: a saddle inside (the
/// sign of H). stage: the latest one of the sides looked at.
Decision face_critical(const FaceValues& f);

}  // namespace crest::kernel
