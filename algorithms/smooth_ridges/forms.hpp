// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Principal directions and extremalities of a surface as functions of two coordinates (certify/
// SPEC.md, claim 4, Forms; paper 002, equations 1 to 3). A number is a jet Field = Jet<T, 2, K>:
// its value, with K = 1 its gradient, with K = 2 its second derivatives along the surface.
//
//   I first form, L second one times |N|, T_ijk = N . X_ijk, D(v) = X_v . X_vv = half the
//   derivative of I(v, v) along v at constant v. A = adj(I) L without its trace; A = 0 at umbilics;
//   its eigenvector of eigenvalue sigma > 0 is d1. E(v) = I(v, v) T(v, v, v) - 3 L(v, v) D(v): for
//   principal v a positive multiple of the derivative of its curvature along v. So E(v1) stands for
//   b0, E(v2) for b3.
#include <array>

#include "algorithms/smooth_ridges/local_geometry.hpp"

namespace crest::smooth_ridges {

/// Values of the symmetric forms: i, l: (11, 12, 22); t, d: coefficients of v1^3, v1^2 v2, v1 v2^2,
/// v2^3, binomials included.
template <class Field>
struct Forms {
  std::array<Field, 3> i, l;
  std::array<Field, 4> t, d;
};

/// A traceless: A = (a, b; c, -a).
template <class Field>
struct Shape {
  Field a, b, c;
};

template <class Field>
using Pair = std::array<Field, 2>;

/// All forms. Requires: K + 3 <= the geometry's order.
template <int K, class Geometry>
Forms<kernel::Jet<typename Geometry::Number, 2, K>> forms_of(const Geometry& geometry) {
  const auto i = geometry.template first<K + 1>();
  const auto d1 = [&](std::size_t k) { return partial<K>(i[k], 1, 0); };
  const auto d2 = [&](std::size_t k) { return partial<K>(i[k], 0, 1); };
  return {{partial<K>(i[0], 0, 0), partial<K>(i[1], 0, 0), partial<K>(i[2], 0, 0)},
          geometry.template second<K>(),
          geometry.template third<K>(),
          {d1(0) * 0.5, d2(0) * 0.5 + d1(1), d1(2) * 0.5 + d2(1), d2(2) * 0.5}};
}

template <class Field>
Shape<Field> shape_of(const std::array<Field, 3>& i, const std::array<Field, 3>& l) {
  const auto& [i11, i12, i22] = i;
  const auto& [l11, l12, l22] = l;
  return {(i22 * l11 - i11 * l22) * 0.5, i22 * l12 - i12 * l22, i11 * l12 - i12 * l11};
}

/// sigma^2.
template <class Field>
Field squared_sigma(const Shape<Field>& s) {
  return s.a * s.a + s.b * s.c;
}

/// A w for constant w: of doubles, or of Lanes for fields side by side.
template <class Field, class Number>
Pair<Field> times(const Shape<Field>& s, const std::array<Number, 2>& w) {
  return {s.a * w[0] + s.b * w[1], s.c * w[0] - s.a * w[1]};
}

/// S(w) = I(w, A w).
template <class Field, class Number>
Field transverse(const std::array<Field, 3>& i, const Pair<Field>& aw,
                 const std::array<Number, 2>& w) {
  return (i[0] * w[0] + i[1] * w[1]) * aw[0] + (i[1] * w[0] + i[2] * w[1]) * aw[1];
}

/// v1 = w + A w / sigma.
template <class Field, class Number>
Pair<Field> first_principal(const Pair<Field>& aw, const Field& sigma,
                            const std::array<Number, 2>& w) {
  const Field factor = inverse(sigma);
  return {aw[0] * factor + w[0], aw[1] * factor + w[1]};
}

/// v2 with I(v1, v2) = 0.
template <class Field>
Pair<Field> second_principal(const std::array<Field, 3>& i, const Pair<Field>& v) {
  return {-(i[1] * v[0] + i[2] * v[1]), i[0] * v[0] + i[1] * v[1]};
}

/// E(v).
template <class Field>
Field extremality(const Forms<Field>& f, const Pair<Field>& v) {
  const Field xx = v[0] * v[0], xy = v[0] * v[1], yy = v[1] * v[1];
  const auto quadratic = [&](const std::array<Field, 3>& q) {
    return q[0] * xx + (q[1] * xy) * 2.0 + q[2] * yy;
  };
  const auto cubic = [&](const std::array<Field, 4>& c) {
    return (c[0] * xx + c[2] * yy) * v[0] + (c[1] * xx + c[3] * yy) * v[1];
  };
  return quadratic(f.i) * cubic(f.t) - (quadratic(f.l) * cubic(f.d)) * 3.0;
}

}  // namespace crest::smooth_ridges
