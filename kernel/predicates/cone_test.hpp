// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cone test: is the dominant eigenvector n of a symmetric tensor T certain, and within 45 degrees
// of the line of w (paper 000, section 2.1.1, made effective)?
//
// Let q = w.Tw / w.w, C = T restricted to the plane across w, mu its larger eigenvalue.
// cone_test(T, w) is positive iff q > mu; zero iff q = mu; negative iff q < mu.
// Theorem (Courant-Fischer; Davis-Kahan). If q > mu, then lambda1 - lambda2 >= q - mu, and the
// angle theta between n and the line of w has tan 2 theta <= 2 |b| / (q - mu), b = the part of T w
// / |w| across w. q - mu is concave in T and |b| convex: what holds for some tensors holds with the
// least q - mu and the largest |b| for all their convex combinations, and n turns by less than 90
// degrees. Without frames: K = q I - T has w.Kw = 0; with K^ = (w.Tw) I - (w.w) T, q > mu iff tr K^
// > 0 and w . adj(K^) w > 0 (trace and determinant of K on the plane).
//
// Laws. (1) cone_test(T, -w) = cone_test(T, w), and for any non-zero multiple of w. (2) T + c I and
// positive multiples of T change nothing. (3) Positive for w = n iff lambda1 is simple. (4)
// Positive at T and at S with the same w: positive at T + S. (5) Two w positive at one T are not
// perpendicular: w.w' has the sign that n gives.
// Not true: that it is positive for every w within 45 degrees of n.
#include <array>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// xx yy zz xy yz xz
template <class T>
using Symmetric3 = std::array<T, 6>;

template <class T>
Vector3<T> product(const Symmetric3<T>& t, const Vector3<T>& w) {
  return {t[0] * w[0] + t[3] * w[1] + t[5] * w[2], t[3] * w[0] + t[1] * w[1] + t[4] * w[2],
          t[5] * w[0] + t[4] * w[1] + t[2] * w[2]};
}

/// K^ above.
template <class T>
Symmetric3<T> cone_matrix(const Symmetric3<T>& t, const Vector3<T>& w) {
  const T q = dot(w, product(t, w)), n = dot(w, w);
  return {q - n * t[0],      q - n * t[1],      q - n * t[2],
          T(0.0) - n * t[3], T(0.0) - n * t[4], T(0.0) - n * t[5]};
}
template <class T>
Symmetric3<T> adjugate(const Symmetric3<T>& k) {
  return {k[1] * k[2] - k[4] * k[4], k[0] * k[2] - k[5] * k[5], k[0] * k[1] - k[3] * k[3],
          k[4] * k[5] - k[3] * k[2], k[3] * k[5] - k[0] * k[4], k[3] * k[4] - k[1] * k[5]};
}
/// w . adj(k) w
template <class T>
T cone_minor(const Symmetric3<T>& k, const Vector3<T>& w) {
  return dot(w, product(adjugate(k), w));
}

struct ConeTrace {
  Symmetric3<double> t;
  Vec3 w;
  static constexpr int depth = 11;
  template <class T>
  T value() const {
    const auto k =
        cone_matrix<T>({T(t[0]), T(t[1]), T(t[2]), T(t[3]), T(t[4]), T(t[5])}, lift<T>(w));
    return k[0] + k[1] + k[2];
  }
};
struct ConeMinor {
  Symmetric3<double> t;
  Vec3 w;
  static constexpr int depth = 29;
  template <class T>
  T value() const {
    return cone_minor(
        cone_matrix<T>({T(t[0]), T(t[1]), T(t[2]), T(t[3]), T(t[4]), T(t[5])}, lift<T>(w)),
        lift<T>(w));
  }
};

/// The sign of q - mu from those of trace and determinant.
constexpr MaybeSign cone_sign(MaybeSign trace, MaybeSign minor) {
  if (minor == Sign::negative || trace == Sign::negative) return Sign::negative;
  if (!minor || !trace) return std::nullopt;
  return *minor == Sign::positive ? *trace : Sign::zero;
}
inline MaybeSign triage_cone_test(const Symmetric3<double>& t, const Vec3& w) {
  return cone_sign(triage(ConeTrace{t, w}), triage(ConeMinor{t, w}));
}
MaybeSign interval_cone_test(const Symmetric3<double>& t, const Vec3& w);
Sign exact_cone_test(const Symmetric3<double>& t, const Vec3& w);

/// Requires: w is not the zero vector; finite numbers.
Decision cone_test(const Symmetric3<double>& t, const Vec3& w);

/// Two unit vectors across the unit vector w and across each other, to a few roundings.
std::array<Vec3, 2> frame_across(const Vec3& w);

/// Triage where the entries of t, at most `size`, carry errors up to `error`: q - mu less its
/// error, so positive only if the test is; w is a unit vector to 2^-50. Proof: q and the entries of
/// C err by 3 error and less than 40 roundings of 3 size, mu by twice that; the sum is below 32
/// error + 2^-43 size.
double cone_margin(const Symmetric3<double>& t, double size, double error, const Vec3& w);

}  // namespace crest::kernel
