// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Nets and forms: the two ways to keep a polynomial on a simplex or a box.
//
// Net: the Bernstein coefficients b, the Bezier net of geometry. Form: s = b times the index's
// weight (the multinomial, the product of binomials), so that products and degree raising are sums
// of products and need no division; every sign of s is one of b. T is any ring with integers
// (Approximate, Depth, Interval, Rational, double, Lanes); nets of forms need division.
//
// Laws. (1) A form's product has the product of the values. (2) raised() changes no value.
// (3) net(form(b)) = b. (4) Enclosure: on the closed cell all values lie between the least and the
// greatest coefficient of the net.
#include "kernel/polynomial/bernstein_basis.hpp"

namespace crest::kernel {

template <class T, class B>
struct Net {
  using Basis = B;
  std::array<T, B::count> c{};
};
template <class T, int Dim, int Degree>
using SimplexNet = Net<T, SimplexBasis<Dim, Degree>>;
template <class T, int... N>
using BoxNet = Net<T, BoxBasis<N...>>;

/// Which pairs of coefficients add to which of a product: pairs[first[k]], ..., pairs[first[k +
/// 1]].
template <class A, class B>
struct ProductTable {
  using Basis = typename ProductBasis<A, B>::type;
  struct Pair {
    std::uint16_t a, b;
  };
  std::array<std::uint32_t, Basis::count + 1> first{};
  std::array<Pair, A::count * B::count> pairs{};
  std::size_t longest = 0;

  static constexpr std::size_t target(std::size_t i, std::size_t k) {
    typename Basis::Index sum{};
    for (std::size_t j = 0; j < sum.size(); ++j)
      sum[j] = static_cast<std::uint8_t>(A::indices[i][j] + B::indices[k][j]);
    return Basis::position(sum);
  }
  static constexpr ProductTable make() {
    ProductTable t;
    for (std::size_t i = 0; i < A::count; ++i)
      for (std::size_t k = 0; k < B::count; ++k) ++t.first[target(i, k) + 1];
    for (std::size_t k = 0; k < Basis::count; ++k) {
      t.longest = t.first[k + 1] > t.longest ? t.first[k + 1] : t.longest;
      t.first[k + 1] += t.first[k];
    }
    std::array<std::uint32_t, Basis::count> used{};
    for (std::size_t i = 0; i < A::count; ++i)
      for (std::size_t k = 0; k < B::count; ++k) {
        const std::size_t to = target(i, k);
        t.pairs[t.first[to] + used[to]++] = {static_cast<std::uint16_t>(i),
                                             static_cast<std::uint16_t>(k)};
      }
    return t;
  }
};
template <class A, class B>
inline constexpr ProductTable<A, B> kProductTable = ProductTable<A, B>::make();

template <class T, class B>
struct Form {
  using Basis = B;
  std::array<T, B::count> s{};

  friend Form operator+(const Form& a, const Form& b) {
    Form r;
    for (std::size_t i = 0; i < B::count; ++i) r.s[i] = a.s[i] + b.s[i];
    return r;
  }
  friend Form operator-(const Form& a, const Form& b) {
    Form r;
    for (std::size_t i = 0; i < B::count; ++i) r.s[i] = a.s[i] - b.s[i];
    return r;
  }
  friend Form operator*(const T& k, const Form& a) {
    Form r;
    for (std::size_t i = 0; i < B::count; ++i) r.s[i] = k * a.s[i];
    return r;
  }
};
template <class T, int Dim, int Degree>
using SimplexForm = Form<T, SimplexBasis<Dim, Degree>>;
template <class T, int... N>
using BoxForm = Form<T, BoxBasis<N...>>;

template <class T, class A, class B>
Form<T, typename ProductBasis<A, B>::type> operator*(const Form<T, A>& a, const Form<T, B>& b) {
  constexpr const auto& table = kProductTable<A, B>;
  Form<T, typename ProductBasis<A, B>::type> r;
  for (std::size_t k = 0; k < r.s.size(); ++k) {
    std::size_t i = table.first[k];
    T sum = a.s[table.pairs[i].a] * b.s[table.pairs[i].b];
    while (++i < table.first[k + 1]) sum = sum + a.s[table.pairs[i].a] * b.s[table.pairs[i].b];
    r.s[k] = sum;
  }
  return r;
}

template <class T, class B>
Form<T, B> form(const Net<T, B>& b) {
  Form<T, B> r;
  for (std::size_t i = 0; i < B::count; ++i) r.s[i] = T(B::weights[i]) * b.c[i];
  return r;
}
template <class T, class B>
Net<T, B> net(const Form<T, B>& s) {
  Net<T, B> r;
  for (std::size_t i = 0; i < B::count; ++i) r.c[i] = s.s[i] / T(B::weights[i]);
  return r;
}
/// Bernstein coefficients of a product.
template <class T, class A, class B>
auto operator*(const Net<T, A>& a, const Net<T, B>& b) {
  return net(form(a) * form(b));
}
/// The constant 1: a product with it raises the degree.
template <class T, class B>
Form<T, B> one() {
  Form<T, B> r;
  for (std::size_t i = 0; i < B::count; ++i) r.s[i] = T(B::weights[i]);
  return r;
}
template <class B, class T, class A>
auto raised(const Form<T, A>& a) {
  return a * one<T, B>();
}

}  // namespace crest::kernel
