// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bezier nets on segments, triangles and tetrahedra: values, gradients, derivatives, by de
// Casteljau's rule. (Parts and faces: simplex_parts.hpp. Products: bernstein_form.hpp.)
//
// Laws. (1) The gradient's products with directions are directional derivatives; value = (sum of
// l_i times gradient_i) / degree. (2) A derivative's net has the values of the derivative. (3) A
// raised net has the same values.
#include "kernel/polynomial/bernstein_form.hpp"

namespace crest::kernel {

template <class T, int Dim>
struct ValueAndGradient {
  T value;
  /// Partial derivatives by the barycentric coordinates l_i, each taken as a variable of its own.
  std::array<T, Dim + 1> gradient;
};

template <int Dim, int Degree>
constexpr auto make_simplex_steps() {
  using Low = SimplexBasis<Dim, Degree - 1>;
  using High = SimplexBasis<Dim, Degree>;
  std::array<std::array<std::uint16_t, Dim + 1>, Low::count> r{};
  for (std::size_t i = 0; i < Low::count; ++i)
    for (std::size_t k = 0; k <= Dim; ++k) {
      typename High::Index a = Low::indices[i];
      ++a[k];
      r[i][k] = static_cast<std::uint16_t>(High::position(a));
    }
  return r;
}
/// kSimplexSteps<Dim, Degree>[i][k]: the position of index i of degree - 1 plus one at corner k.
template <int Dim, int Degree>
inline constexpr auto kSimplexSteps = make_simplex_steps<Dim, Degree>();

/// Sum of w_k times the coefficients one index up at k: one level of de Casteljau (sum of w is 1),
/// or a derivative without its factor (sum 0).
template <class T, int Dim, int Degree>
SimplexNet<T, Dim, Degree - 1> blossom_step(const SimplexNet<T, Dim, Degree>& b,
                                            const std::array<T, Dim + 1>& w) {
  SimplexNet<T, Dim, Degree - 1> r;
  for (std::size_t i = 0; i < r.c.size(); ++i) {
    const auto& up = kSimplexSteps<Dim, Degree>[i];
    T sum = w[0] * b.c[up[0]];
    for (std::size_t k = 1; k <= Dim; ++k) sum = sum + w[k] * b.c[up[k]];
    r.c[i] = sum;
  }
  return r;
}

template <class T, int Dim, int Degree>
T value_at(const SimplexNet<T, Dim, Degree>& b, const std::array<T, Dim + 1>& l) {
  if constexpr (Degree == 0)
    return b.c[0];
  else
    return value_at(blossom_step(b, l), l);
}

template <class T, int Dim, int Degree>
ValueAndGradient<T, Dim> value_and_gradient_at(const SimplexNet<T, Dim, Degree>& b,
                                               const std::array<T, Dim + 1>& l) {
  static_assert(Degree >= 1);
  if constexpr (Degree > 1) {
    ValueAndGradient<T, Dim> r = value_and_gradient_at(blossom_step(b, l), l);
    // The last level has the gradient of degree - 1.
    for (T& g : r.gradient) g = g * T(Degree) / T(Degree - 1);
    return r;
  } else {
    ValueAndGradient<T, Dim> r{b.c[0] * l[0], b.c};
    for (std::size_t k = 1; k <= Dim; ++k) r.value = r.value + b.c[k] * l[k];
    return r;
  }
}

/// The derivative along w, given in barycentric coordinates (sum 0).
template <class T, int Dim, int Degree>
SimplexNet<T, Dim, Degree - 1> derivative(const SimplexNet<T, Dim, Degree>& b,
                                          const std::array<T, Dim + 1>& w) {
  auto r = blossom_step(b, w);
  for (T& x : r.c) x = T(Degree) * x;
  return r;
}

/// The same polynomial with degree one higher.
template <class T, int Dim, int Degree>
SimplexNet<T, Dim, Degree + 1> raised(const SimplexNet<T, Dim, Degree>& b) {
  SimplexNet<T, Dim, Degree + 1> r;
  r.c.fill(T(0));
  for (std::size_t i = 0; i < b.c.size(); ++i)
    for (std::size_t k = 0; k <= Dim; ++k) {
      const std::size_t to = kSimplexSteps<Dim, Degree + 1>[i][k];
      const T share(SimplexBasis<Dim, Degree + 1>::indices[to][k]);
      r.c[to] = r.c[to] + share * b.c[i];
    }
  for (T& x : r.c) x = x / T(Degree + 1);
  return r;
}

}  // namespace crest::kernel
