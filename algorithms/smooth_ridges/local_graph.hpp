// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The jets that differential quantities are made of, over any number type T.
//
// An implicit surface is, where F_m != 0, a graph m = h(p, q) over the plane of two axes (certify/
// SPEC.md, claim 4, Forms: (p, q, m) in cyclic order). The jet of h follows degree by degree from
// F(p, q, h(p, q)) = 0: the terms of degree d hold the unknown coefficients of degree d in F_m h
// alone.
#include <array>
#include <cstddef>

#include "kernel/arithmetic/jet.hpp"

namespace crest::smooth_ridges {

/// The K-jet of the derivative D^(a, b) f.
template <int K, class T, int Order>
kernel::Jet<T, 2, K> partial(const kernel::Jet<T, 2, Order>& f, int a, int b) {
  constexpr kernel::Monomials<2, K> table;
  kernel::Jet<T, 2, K> r;
  for (std::size_t k = 0; k < kernel::Jet<T, 2, K>::kCount; ++k) {
    const int i = table.exponents[k][0], j = table.exponents[k][1];
    const std::size_t at = kernel::JetTables<2, Order>::digits(i + a, j + b);
    const std::size_t from = kernel::Jet<T, 2, Order>::kTables.position[at];
    if ((f.mask() >> from & 1) == 0) continue;
    double factor = 1;
    for (int n = i + 1; n <= i + a; ++n) factor *= n;
    for (int n = j + 1; n <= j + b; ++n) factor *= n;
    r.set(k, factor == 1 ? f[from] : T(f[from] * factor));
  }
  return r;
}

/// The axes p, q of a graph along the axis m.
constexpr std::array<std::size_t, 2> plane_axes(std::size_t m) {
  return {(m + 1) % 3, (m + 2) % 3};
}

template <class T, int Order>
class GraphJet {
 public:
  using Surface = kernel::Jet<T, 3, Order>;
  using Graph = kernel::Jet<T, 2, Order>;

  /// The jet of h with h(0, 0) = 0. Requires: F_m not zero.
  static Graph of(const Surface& f, std::size_t axis) { return GraphJet(f, axis).solve(); }

 private:
  static constexpr kernel::Monomials<2, Order> kPlane{};
  static constexpr kernel::Monomials<3, Order> kSpace{};

  GraphJet(const Surface& f, std::size_t axis) : f_(f), axis_(axis) {}

  static std::size_t place(int i, int j) {
    return Graph::kTables.position[kernel::JetTables<2, Order>::digits(i, j)];
  }

  Graph solve() {
    std::array<int, 3> unit{};
    unit[axis_] = 1;
    const T& slope = f_.coefficient(unit[0], unit[1], unit[2]);
    const T factor = kernel::number_like(-1, &slope) / slope;
    for (int d = 1; d <= Order; ++d) {
      for (int i = 0; i <= d; ++i) extend_powers(i, d - i);
      for (int i = 0; i <= d; ++i) {
        bool any = false;
        const T rest = residual(i, d - i, any);
        if (any) powers_[1].set(place(i, d - i), T(rest * factor));
      }
    }
    return powers_[1];
  }

  /// h^c for c >= 2 at (i, j): coefficients of h of lower degree.
  void extend_powers(int i, int j) {
    for (std::size_t c = 2; c <= static_cast<std::size_t>(i + j); ++c)
      for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l)
          add(powers_[c], place(i, j), powers_[1], place(k, l), powers_[c - 1],
              place(i - k, j - l));
  }
  static void add(Graph& sum, std::size_t at, const Graph& a, std::size_t ia, const Graph& b,
                  std::size_t ib) {
    if ((a.mask() >> ia & 1) == 0 || (b.mask() >> ib & 1) == 0) return;
    T value = a[ia] * b[ib];
    sum.set(at, (sum.mask() >> at & 1) != 0 ? T(sum[at] + value) : value);
  }

  /// The coefficient of p^i q^j in F(p, q, h) but for F_m h_ij.
  T residual(int i, int j, bool& any) const {
    const auto [p, q] = plane_axes(axis_);
    T sum = kernel::number_like(0, &f_[0]);
    kernel::for_each_bit(f_.mask() & ~std::uint64_t{1}, [&](std::size_t at) {
      const auto& e = kSpace.exponents[at];
      const int k = i - e[p], l = j - e[q];
      const std::size_t c = e[axis_];
      if (k < 0 || l < 0) return;
      if (c == 0) {
        if (k == 0 && l == 0) sum = sum + f_[at], any = true;
        return;
      }
      const std::size_t from = place(k, l);
      if ((powers_[c].mask() >> from & 1) == 0) return;
      sum = sum + f_[at] * powers_[c][from];
      any = true;
    });
    return sum;
  }

  const Surface& f_;
  std::size_t axis_;
  std::array<Graph, Order + 1> powers_;  ///< of h, from the first
};

}  // namespace crest::smooth_ridges
