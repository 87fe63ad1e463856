// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Signs at the roots of a quadratic a x^2 + b x + c without square roots: does it have real roots,
// which sign has another quadratic there, which of two roots is smaller.
//
// A source of coefficients is a struct with `template <class T> QuadraticOf<T> value() const` and
// `static constexpr int depth` (the largest rounding depth of a coefficient): coefficients may be
// determinants of data. A source whose leading coefficient is exactly zero is linear, both roots
// are its one root.
//
// With q = e x^2 + f x + g: a q(r) = A r + B, A = a f - e b, B = a g - e c, so the sign of q(r) is
// that of U + V sqrt(D), U = 2 a B - A b, V = +-A, D = b^2 - 4 a c; where U and V differ in sign,
// that of U^2 - V^2 D = 4 a R, R = a B^2 - b A B + c A^2, decides.
//
// Laws. (1) A positive factor of p changes nothing; a negative one neither (smaller and larger are
// places). (2) Negating q negates the sign. (3) q = p gives zero. (4) root_order is antisymmetric
// and zero iff the roots are equal. (5) Mirroring x exchanges smaller and larger.
#include <algorithm>
#include <optional>

#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

template <class T>
struct QuadraticOf {
  T a, b, c;
};

/// Coefficients given as doubles. Requires: finite.
struct Quadratic {
  double a, b, c;
  static constexpr int depth = 0;
  template <class T>
  QuadraticOf<T> value() const {
    return {T(a), T(b), T(c)};
  }
};
/// 2 a x + b.
template <class P>
struct QuadraticSlope {
  P p;
  static constexpr int depth = P::depth + 2;
  template <class T>
  QuadraticOf<T> value() const {
    const auto v = p.template value<T>();
    return {T(0.0), T(2.0) * v.a, v.b};
  }
};

template <class P>
struct QuadraticLeading {
  P p;
  static constexpr int depth = P::depth;
  template <class T>
  T value() const {
    return p.template value<T>().a;
  }
};
template <class P>
struct QuadraticMiddle {
  P p;
  static constexpr int depth = P::depth;
  template <class T>
  T value() const {
    return p.template value<T>().b;
  }
};
template <class P>
struct QuadraticDiscriminant {
  P p;
  static constexpr int depth = 2 * P::depth + 5;
  template <class T>
  T value() const {
    const auto v = p.template value<T>();
    return v.b * v.b - T(4.0) * (v.a * v.c);
  }
};

/// A (slope), U (rational_part) and R (resultant) of the header's derivation, and q at the root of
/// a linear p times b^2 (at_linear_root).
template <class P, class Q>
struct RootTerms {
  P p;
  Q q;
  static constexpr int kA = P::depth + Q::depth + 3;
  template <class T>
  static QuadraticOf<T> remainder(const QuadraticOf<T>& u, const QuadraticOf<T>& v) {
    return {T(0.0), u.a * v.b - v.a * u.b, u.a * v.c - v.a * u.c};
  }
};
template <class P, class Q>
struct RootSlope : RootTerms<P, Q> {
  static constexpr int depth = RootTerms<P, Q>::kA;
  template <class T>
  T value() const {
    return this->remainder(this->p.template value<T>(), this->q.template value<T>()).b;
  }
};
template <class P, class Q>
struct RootRationalPart : RootTerms<P, Q> {
  static constexpr int depth = P::depth + RootTerms<P, Q>::kA + 5;
  template <class T>
  T value() const {
    const auto u = this->p.template value<T>();
    const auto r = this->remainder(u, this->q.template value<T>());
    return T(2.0) * (u.a * r.c) - r.b * u.b;
  }
};
template <class P, class Q>
struct RootResultant : RootTerms<P, Q> {
  static constexpr int depth = P::depth + 2 * RootTerms<P, Q>::kA + 6;
  template <class T>
  T value() const {
    const auto u = this->p.template value<T>();
    const auto r = this->remainder(u, this->q.template value<T>());
    return (u.a * r.c * r.c - u.b * r.b * r.c) + u.c * r.b * r.b;
  }
};
template <class P, class Q>
struct AtLinearRoot : RootTerms<P, Q> {
  static constexpr int depth = 2 * P::depth + Q::depth + 6;
  template <class T>
  T value() const {
    const auto u = this->p.template value<T>();
    const auto v = this->q.template value<T>();
    return (v.a * u.c * u.c - v.b * u.b * u.c) + v.c * u.b * u.b;
  }
};

enum class QuadraticRoot : std::uint8_t { smaller, larger };

/// Two, one (double, or of a linear p) or no real roots; positive, zero, negative. Requires: p not
/// linear.
template <class P>
Decision discriminant_sign(const P& p) {
  return climb(QuadraticDiscriminant<P>{p});
}

}  // namespace crest::kernel
