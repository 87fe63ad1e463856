// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of an immersed surface X(U, V) from the Taylor coefficients of its three coordinates
// (SPEC.md, "Forms", kind 1).
#include "certify/ridges_smooth/graph_forms.hpp"
#include "certify/ridges_smooth/vector.hpp"

namespace crest::certify::smooth {

template <class F>
using Triple = std::array<F, 3>;

/// Condition (A) where the jets were taken: a defined value proves that all parts of its expression
/// are defined and analytic (kernel/arithmetic/defined.hpp).
template <class Jet>
bool are_defined(const Triple<Jet>& x) {
  return is_defined(x[0]) && is_defined(x[1]) && is_defined(x[2]);
}

/// D^(a, b) X. Jet: an indexable expansion with mask(), up to `Order`.
template <class F, int Order, class Jet>
Triple<F> derivative(const Triple<Jet>& x, int a, int b) {
  return {F::template derivative_of<Order>(x[0], a, b),
          F::template derivative_of<Order>(x[1], a, b),
          F::template derivative_of<Order>(x[2], a, b)};
}

/// N = X_1 x X_2, not normalized.
template <class F>
struct Tangents {
  Triple<F> x1, x2, n;
};
template <int K, int Order, class M, class Jet>
Tangents<Local<M, K>> fill_immersion(const Triple<Jet>& x, FirstSecond<M, K>& f) {
  using F = Local<M, K>;
  Tangents<F> t{derivative<F, Order>(x, 1, 0), derivative<F, Order>(x, 0, 1), {}};
  t.n = smooth::cross(t.x1, t.x2);
  f.i = {smooth::dot(t.x1, t.x1), smooth::dot(t.x1, t.x2), smooth::dot(t.x2, t.x2)};
  for (int k = 0; k < 3; ++k)
    f.l[static_cast<std::size_t>(k)] = smooth::dot(t.n, derivative<F, Order>(x, 2 - k, k));
  return t;
}

template <int K, int Order, class M, class Jet>
Forms<M, K> immersion_forms(const Triple<Jet>& x) {
  using F = Local<M, K>;
  Forms<M, K> f;
  const auto [x1, x2, n] = fill_immersion<K, Order>(x, f);
  for (int k = 0; k < 4; ++k)
    f.t[static_cast<std::size_t>(k)] = smooth::dot(n, derivative<F, Order>(x, 3 - k, k));
  const auto x11 = derivative<F, Order>(x, 2, 0), x12 = derivative<F, Order>(x, 1, 1),
             x22 = derivative<F, Order>(x, 0, 2);
  f.c = {smooth::dot(x1, x11), smooth::dot(x1, x12) * 2.0 + smooth::dot(x2, x11),
         smooth::dot(x1, x22) + smooth::dot(x2, x12) * 2.0, smooth::dot(x2, x22)};
  return f;
}

/// By the cheaper of the two, where X is a height field.
template <int K, int Order, class M, class Jet>
Forms<M, K> surface_forms(const Triple<Jet>& x) {
  if (const auto graph = height_field<M>(x)) return graph_forms<K, Order>(*graph);
  return immersion_forms<K, Order, M>(x);
}
template <int K, int Order, class M, class Jet>
void fill_surface(const Triple<Jet>& x, FirstSecond<M, K>& f) {
  if (const auto graph = height_field<M>(x))
    fill_graph<K, Order>(*graph, f);
  else
    fill_immersion<K, Order>(x, f);
}

}  // namespace crest::certify::smooth
