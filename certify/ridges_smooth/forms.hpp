// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of SPEC.md, "Forms": I, L, T, X_v . X_vv, A, S, v1, v2, E1, E2,
// written once for every number type and order of differentiation.
#include <array>

#include "certify/ridges_smooth/local.hpp"

namespace crest::certify::smooth {

/// Direction number k (0..127).
constexpr std::array<double, 2> direction(int k) {
  return k < 64 ? std::array{32.0, k - 32.0} : std::array{96.0 - k, 32.0};
}

/// The two fundamental forms as 11, 12, 22 (the second times |N|).
template <class M, int K>
struct FirstSecond {
  std::array<Local<M, K>, 3> i, l;
};

/// All forms of the third order. T and the cubic form C(v) = X_v . X_vv as 111, 112, 122, 222: the
/// coefficients are t0 + 3 t1 + 3 t2 + t3, but c0 + c1 + c2 + c3.
template <class M, int K>
struct Forms : FirstSecond<M, K> {
  std::array<Local<M, K>, 4> t, c;
  /// Of a graph alone: C(v) = h_v h_vv is a product, which is cheaper.
  bool graph = false;
  double sign = 1;
  std::array<Local<M, K>, 2> h;
};

template <class F>
struct Shape {
  F a, b, c;  ///< A_11, A_12, A_21; A_22 = -A_11
};

/// adj(I) L without its trace.
template <class M, int K>
Shape<Local<M, K>> shape(const FirstSecond<M, K>& f) {
  return {(f.i[2] * f.l[0] - f.i[0] * f.l[2]) * 0.5, f.i[2] * f.l[1] - f.i[1] * f.l[2],
          f.i[0] * f.l[1] - f.i[1] * f.l[0]};
}

template <class F>
using Pair = std::array<F, 2>;

// Constant directions: of doubles, or of Lanes for values side by side.
template <class F, class Number>
Pair<F> apply(const Shape<F>& a, const std::array<Number, 2>& w) {
  return {a.a * w[0] + a.b * w[1], a.c * w[0] - a.a * w[1]};
}
/// I(w, x) for a constant w.
template <class F, class Number>
F inner(const std::array<F, 3>& i, const std::array<Number, 2>& w, const Pair<F>& x) {
  return (i[0] * w[0] + i[1] * w[1]) * x[0] + (i[1] * w[0] + i[2] * w[1]) * x[1];
}
template <class M, int K>
std::array<M, 3> values(const std::array<Local<M, K>, 3>& x) {
  return {x[0].value(), x[1].value(), x[2].value()};
}
template <class M, int K>
Shape<M> values(const Shape<Local<M, K>>& a) {
  return {a.a.value(), a.b.value(), a.c.value()};
}
/// S(w) = I(w, A w), without derivatives.
template <class M, int K, class Number>
M s_of(const std::array<Local<M, K>, 3>& i, const Shape<Local<M, K>>& a,
       const std::array<Number, 2>& w) {
  return inner(values(i), w, smooth::apply(values(a), w));
}

/// v1 = w + A w / sigma.
template <class F, class Number>
Pair<F> principal(const Shape<F>& a, const std::array<Number, 2>& w) {
  const F factor = inverse(sqrt(a.a * a.a + a.b * a.c));
  const Pair<F> aw = apply(a, w);
  using M = typename F::Number;
  return {factor * aw[0] + F(M(w[0])), factor * aw[1] + F(M(w[1]))};
}
/// v2: v turned by a right angle of I.
template <class F>
Pair<F> turned(const std::array<F, 3>& i, const Pair<F>& v) {
  return {-(i[1] * v[0] + i[2] * v[1]), i[0] * v[0] + i[1] * v[1]};
}

/// E(v) = I(v, v) T(v, v, v) - 3 L(v, v) C(v).
template <class M, int K>
Local<M, K> extremality(const Forms<M, K>& f, const Pair<Local<M, K>>& v) {
  using F = Local<M, K>;
  const F v11 = v[0] * v[0], v12 = v[0] * v[1], v22 = v[1] * v[1];
  const F ivv = f.i[0] * v11 + (f.i[1] * v12) * 2.0 + f.i[2] * v22;
  const F lvv = f.l[0] * v11 + (f.l[1] * v12) * 2.0 + f.l[2] * v22;
  const F tvvv =
      (f.t[0] * v[0] + (f.t[1] * v[1]) * 3.0) * v11 + ((f.t[2] * v[0]) * 3.0 + f.t[3] * v[1]) * v22;
  if (f.graph) {
    const F hv = f.h[0] * v[0] + f.h[1] * v[1];
    return ivv * tvvv - (lvv * lvv * hv) * (3.0 * f.sign);
  }
  const F c = (f.c[0] * v[0] + f.c[1] * v[1]) * v11 + (f.c[2] * v[0] + f.c[3] * v[1]) * v22;
  return ivv * tvvv - (lvv * c) * 3.0;
}

/// E(v) as a form in v: the coefficient of v_1^(5 - k) v_2^k. Fills c of a graph itself.
template <class M, int K>
std::array<Local<M, K>, 6> quintic(const Forms<M, K>& f) {
  using F = Local<M, K>;
  std::array<F, 4> c = f.c;
  if (f.graph) {
    const std::array<F, 3> hh = {f.l[0] * f.sign, f.l[1] * f.sign, f.l[2] * f.sign};
    c = {f.h[0] * hh[0], f.h[0] * hh[1] * 2.0 + f.h[1] * hh[0],
         f.h[0] * hh[2] + f.h[1] * hh[1] * 2.0, f.h[1] * hh[2]};
  }
  const std::array<F, 3> i = {f.i[0], f.i[1] * 2.0, f.i[2]}, l = {f.l[0], f.l[1] * 2.0, f.l[2]};
  const std::array<F, 4> t = {f.t[0], f.t[1] * 3.0, f.t[2] * 3.0, f.t[3]};
  std::array<F, 6> q;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 4; ++b) q[a + b] = q[a + b] + i[a] * t[b] - l[a] * c[b] * 3.0;
  return q;
}

}  // namespace crest::certify::smooth
