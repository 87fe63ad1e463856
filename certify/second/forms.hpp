// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Graph", "Forms", "Height fields": what is derived from the surface at all points of a
// piece (T = Model), or at one point (T = Ball).
#include <optional>

#include "certify/second/jet.hpp"
#include "certify/second/model.hpp"

namespace crest::recheck {

template <class T>
using Jet2 = Jet<T, 2>;
template <class T>
using Jet3 = Jet<T, 3>;
template <class T>
using Vector = std::array<T, 3>;
template <class T>
using Form = std::vector<Jet2<T>>;  ///< f_k of v1^(n-k) v2^k
template <class T>
using Direction = std::array<Jet2<T>, 2>;

/// The surface near the points, as jets in its two coordinates: I, L, T and
/// C(v, v, v) = X_v . X_vv, which give E(v) = I(v, v) T(v, v, v) - 3 L(v, v) C(v, v, v).
template <class T>
struct Forms {
  Form<T> i, l, t, c;
};

/// A: its entries A_11, A_12, A_21.
template <class T>
struct Operator {
  Jet2<T> a11, a12, a21;
};

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// a + s b.
template <class T>
Vector<T> moved(const Vector<T>& a, const T& s, const Vector<T>& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
template <class T>
T determinant(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  T d{};
  for (Index k = 0; k < 3; ++k)
    d = d + (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) * c[k];
  return d;
}

template <class T>
Jet2<T> evaluate(const Form<T>& f, const Direction<T>& v) {
  Jet2<T> r = f[0], power = v[1];
  for (Index k = 1; k < f.size(); ++k) {
    r = r * v[0] + f[k] * power;
    if (k + 1 < f.size()) power = power * v[1];
  }
  return r;
}

template <class T>
Form<T> operator+(Form<T> a, const Form<T>& b) {
  for (Index k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}
template <class T>
Form<T> product(const Form<T>& a, const Form<T>& b) {
  Form<T> r(a.size() + b.size() - 1);
  for (Index i = 0; i < a.size(); ++i)
    for (Index j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  return r;
}
template <class T>
Form<T> multiple(const Jet2<T>& factor, const Form<T>& f) {
  return product(Form<T>{factor}, f);
}

/// The coefficients of E as a form of degree 5.
template <class T>
Form<T> quintic(const Forms<T>& f) {
  return product(f.i, f.t) + multiple(Jet2<T>(-3.0), product(f.l, f.c));
}
template <class T>
Jet2<T> extremality(const Forms<T>& f, const Direction<T>& v) {
  return evaluate(f.i, v) * evaluate(f.t, v) - scaled(evaluate(f.l, v) * evaluate(f.c, v), 3, 1);
}

template <class T>
Operator<T> operator_of(const Forms<T>& f) {
  const Jet2<T>&i11 = f.i[0], &i22 = f.i[2], &l11 = f.l[0], &l22 = f.l[2];
  const Jet2<T> i12 = scaled(f.i[1], 1, 2), l12 = scaled(f.l[1], 1, 2);
  return {scaled(i22 * l11 - i11 * l22, 1, 2), i22 * l12 - i12 * l22, i11 * l12 - i12 * l11};
}
/// S(w).
template <class T>
T definite(const Form<T>& i, const Operator<T>& a, const std::array<int, 2>& w) {
  const T &i11 = i[0][0], &i22 = i[2][0], &a11 = a.a11[0], i12 = scaled(i[1][0], 1, 2);
  return (scaled(i11, w[0]) + scaled(i12, w[1])) * (scaled(a11, w[0]) + scaled(a.a12[0], w[1])) +
         (scaled(i12, w[0]) + scaled(i22, w[1])) * (scaled(a.a21[0], w[0]) - scaled(a11, w[1]));
}
template <class T>
Jet2<T> root(const Operator<T>& a) {
  return sqrt(a.a11 * a.a11 + a.a12 * a.a21);
}
/// v1 and v2 for w, of I and A, as jets.
/// Throws: Undefined if sigma^2 > 0 is left open.
template <class T>
std::array<Direction<T>, 2> directions(const Form<T>& i, const Operator<T>& a,
                                       const std::array<int, 2>& w) {
  const Jet2<T> q = inverse(root(a)), i12 = scaled(i[1], 1, 2);
  const Direction<T> v = {Jet2<T>(w[0]) + (scaled(a.a11, w[0], 1) + scaled(a.a12, w[1], 1)) * q,
                          Jet2<T>(w[1]) + (scaled(a.a21, w[0], 1) - scaled(a.a11, w[1], 1)) * q};
  return {v, Direction<T>{-(i12 * v[0] + i[2] * v[1]), i[0] * v[0] + i12 * v[1]}};
}
/// w or c by its number.
inline std::array<int, 2> direction(int number) {
  return number < 64 ? std::array<int, 2>{32, number - 32} : std::array<int, 2>{96 - number, 32};
}

/// Of the surface's own jet, for forms of degree context.jet_order.
inline int jet_degree() {
  return std::min(3 + context.jet_order, 5);
}

/// The series h(p, q), h(0, 0) = 0, with f(p, q, h) = f(0, 0, 0): degree by degree, as the part of
/// f of degree k is what lower parts of h give, and F_m times the one of degree k.
template <class T>
Jet2<T> height_of(const Jet3<T>& f, int degree) {
  const auto& two = Monomials<2>::get();
  const auto& three = Monomials<3>::get();
  const Index m = Monomials<3>::unit(2);
  const T step = -inverse(f[m]);
  std::vector<Jet2<T>> powers(static_cast<Index>(degree) + 1);  // of h, those of index 0 unused
  for (int k = 1; k <= degree; ++k) {
    const auto begin = [&](int d) { return two.count[static_cast<Index>(d)]; };
    for (Index l = 2; l <= static_cast<Index>(k); ++l)
      for (Index a = begin(1); a < begin(k); ++a)
        for (Index b = begin(k - two.degree[a]); b < begin(k - two.degree[a] + 1); ++b)
          powers[l].at(two.product[a][b]).add_product(powers[1][a], powers[l - 1][b]);
    Jet2<T> rest;
    for (Index i = 1; i < f.size(); ++i) {
      if (i == m || three.degree[i] > k || f[i].is_zero()) continue;
      const auto& e = three.exponents[i];
      const Index pq = two.find({e[0], e[1]});
      if (e[2] == 0) {
        if (three.degree[i] == k) rest.at(pq) = rest[pq] + f[i];
        continue;
      }
      const Jet2<T>& power = powers[static_cast<Index>(e[2])];
      for (Index b = begin(k - e[0] - e[1]); b < begin(k - e[0] - e[1] + 1); ++b)
        rest.at(two.product[pq][b]).add_product(f[i], power[b]);
    }
    for (Index b = begin(k); b < begin(k + 1); ++b) powers[1].at(b) = step * rest[b];
  }
  return powers[1];
}

/// The derivatives of x of order 1, 2, 3 as forms, with jets of degree context.jet_order.
template <class T>
std::array<Form<T>, 3> derivatives(const Jet2<T>& x) {
  const int r = context.jet_order;
  const auto derived = [r](const Jet2<T>& f, Index i, int degree) {
    const Scope scope(r + degree);
    return f.derivative(i);
  };
  const Jet2<T> x1 = derived(x, 0, 2), x2 = derived(x, 1, 2);
  const Jet2<T> x11 = derived(x1, 0, 1), x12 = derived(x1, 1, 1), x22 = derived(x2, 1, 1);
  return {Form<T>{x1.cut(), x2.cut()}, Form<T>{x11.cut(), scaled(x12.cut(), 2, 1), x22.cut()},
          Form<T>{derived(x11, 0, 0), scaled(derived(x11, 1, 0), 3, 1),
                  scaled(derived(x22, 0, 0), 3, 1), derived(x22, 1, 0)}};
}

/// Of a height over coordinates in which I is `flat` + h_i h_j.
template <class T>
Forms<T> forms_of_height(const Jet2<T>& h, const Form<T>& flat, int sign) {
  auto d = derivatives(h);
  Forms<T> f = {flat + product(d[0], d[0]), {}, {}, product(d[0], d[1])};
  if (sign < 0)
    for (const Index order : {1, 2})
      for (Jet2<T>& x : d[order]) x = -x;
  f.l = std::move(d[1]);
  f.t = std::move(d[2]);
  return f;
}

template <class T>
Forms<T> forms_of_immersion(const std::array<Jet2<T>, 3>& x) {
  std::array<std::array<Form<T>, 3>, 3> d;
  for (Index k = 0; k < 3; ++k) d[k] = derivatives(x[k]);
  Forms<T> f = {Form<T>(3), Form<T>(3), Form<T>(4), Form<T>(4)};
  for (Index k = 0; k < 3; ++k) {
    const Form<T>&a = d[(k + 1) % 3][0], &b = d[(k + 2) % 3][0];
    const Jet2<T> normal = a[0] * b[1] - b[0] * a[1];
    f = {f.i + product(d[k][0], d[k][0]), f.l + multiple(normal, d[k][1]),
         f.t + multiple(normal, d[k][2]), f.c + product(d[k][0], d[k][1])};
  }
  return f;
}

/// The height field that x is if two coordinates are affine and independent.
template <class T>
std::optional<Forms<T>> forms_of_height_field(const std::array<Jet2<T>, 3>& x) {
  for (Index k = 0; k < 3; ++k) {
    const Jet2<T>&a = x[(k + 1) % 3], &b = x[(k + 2) % 3];
    if (a.degree() > 1 || b.degree() > 1) continue;
    const int sign = (a[1] * b[2] - a[2] * b[1]).sign();
    if (sign == 0) continue;
    return forms_of_height(
        x[k],
        Form<T>{Jet2<T>(a[1] * a[1] + b[1] * b[1]), Jet2<T>(scaled(a[1] * a[2] + b[1] * b[2], 2)),
                Jet2<T>(a[2] * a[2] + b[2] * b[2])},
        sign);
  }
  return std::nullopt;
}

}  // namespace crest::recheck
