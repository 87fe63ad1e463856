// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Direction sign: the sign of n . v, n the dominant eigenvector of a symmetric tensor T, oriented
// by n . w > 0 (paper 000, section 2.1.1, at nodes).
//
// Theorem. Let w pass the cone test at T, W = w.w, K^ its matrix, b^ = W T w - (w.Tw) w. Then
// tan theta <= |b| / (q - mu), and q - mu >= det / tr of K across w, so
//   (w.v)^2 minor^2 > |b^|^2 |v|^2 W^2 (tr K^)^2
// proves that n . v has the sign of w . v.
// Zero is decided in rationals, where lambda1 is simple. v = 0: zero. v x Tv = 0: v is an
// eigenvector, and n . v = 0 iff it is not lambda1's, that is iff 2 (v.w)^2 < |v|^2 W (law 1 of
// what the cone test proves: n is within 45 degrees of w, all other eigenvectors are not). Else
// det(v, Tv, T^2 v) = 0: u = v x Tv is an eigenvector, and n . v = 0 iff it is lambda1's: v and Tv
// span a plane of the other eigenvectors, or one that holds n and in which v is none. Else v has
// a part along every eigenvector.
// Symbolic: the sign of the first coordinate of n that is not zero; it stands for adding the
// gradient of eps x + eps^2 y + eps^3 z to v.
//
// Form sign: of n^T M n, M symmetric, by f(x) = tr(adj(x I - T) M), which at lambda1 is a positive
// multiple of it; p is T's characteristic polynomial. Zero iff f(lambda1) = 0, decided without
// lambda1: f = 0; or f, of degree 1, has its root in common with p, and that is not below q =
// w.Tw/W, as of p's roots lambda1 alone is; or f, of degree 2, divides p and p's third root is
// below q (lambda1 is simple: that or a root of f); or else p mod f has its root in common with f,
// not below q. If it is not zero, |n^T M n - w^T M w / W| <= 2 tan theta |M| decides for some w
// near n.
//
// Laws. (1) odd in v; odd in w. (2) the same for positive multiples of v and w, for T + c I and
// positive multiples of T. (3) the same for all w that pass the cone test on one side. (4)
// symbolic: never zero. (5) form sign: odd in M, the same for M + v v^T where n . v = 0.
#include <array>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/predicates/cone_test.hpp"

namespace crest::kernel {

/// t, v with errors up to t_error, v_error in every entry (at least 2^-48 of the largest), w a unit
/// vector to 2^-50 that is near n. Empty, too, where w does not pass the cone test.
MaybeSign triage_direction_sign(const Symmetric3<double>& t, double t_error, const Vec3& v,
                                double v_error, const Vec3& w);
/// Requires: w passes the cone test at t. Zero means exactly zero.
Sign exact_direction_sign(const Symmetric3<Rational>& t, const Vector3<Rational>& v,
                          const Vector3<Rational>& w);
/// The sign of the first coordinate of n that is not zero.
Sign symbolic_direction_sign(const Symmetric3<Rational>& t, const Vector3<Rational>& w);

/// The sign of n^T M n. Requires: w passes the cone test at t. Zero means exactly zero.
Sign exact_form_sign(const Symmetric3<Rational>& t, const Symmetric3<Rational>& m,
                     const Vector3<Rational>& w);

/// Requires: w, a unit vector to 2^-50, passes the cone test at t. Never zero.
Decision direction_sign(const Symmetric3<double>& t, const Vec3& v, const Vec3& w);

}  // namespace crest::kernel
