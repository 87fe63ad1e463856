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
#include "kernel/arithmetic/sparse_array.hpp"

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
  static constexpr kernel::Monomials<3, Order> kSpace{};
  using Coefficients = kernel::SparseArray<T, Graph::kCount>;

  GraphJet(const Surface& f, std::size_t axis) : f_(f), axis_(axis) {}

  static std::size_t place(int i, int j) {
    return Graph::kTables.position[kernel::JetTables<2, Order>::digits(i, j)];
  }

  Graph solve() {
    std::array<int, 3> unit{};
    unit[axis_] = 1;
    const T& slope = f_.coefficient(unit[0], unit[1], unit[2]);
    const T factor = kernel::number_like(-1, &slope) / slope;
    Graph h;
    for (int d = 1; d <= Order; ++d) {
      for (int i = 0; i <= d; ++i) extend_powers(i, d - i);
      for (int i = 0; i <= d; ++i) {
        const std::size_t at = place(i, d - i);
        add_residual(i, d - i);
        if (!powers_[1].has(at)) continue;
        h.set(at, T(powers_[1][at] * factor));
        powers_[1].put(at, h[at]);
      }
    }
    return h;
  }

  /// h^c for c >= 2 at (i, j): coefficients of h of lower degree.
  void extend_powers(int i, int j) {
    for (std::size_t c = 2; c <= static_cast<std::size_t>(i + j); ++c)
      for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l) {
          const std::size_t a = place(k, l), b = place(i - k, j - l);
          if (powers_[1].has(a) && powers_[c - 1].has(b))
            add(powers_[c], place(i, j), powers_[1][a], powers_[c - 1][b]);
        }
  }
  /// sums_at += x y.
  static void add(Coefficients& sums, std::size_t at, const T& x, const T& y) {
    using kernel::add_product;
    if (sums.has(at))
      add_product(sums.place(at), x, y);
    else
      sums.make(at, [&] { return T(x * y); });
  }

  /// To h at (i, j) the coefficient of p^i q^j in F(p, q, h) but for F_m h_ij.
  void add_residual(int i, int j) {
    const auto [p, q] = plane_axes(axis_);
    const std::size_t to = place(i, j);
    Coefficients& h = powers_[1];
    kernel::for_each_bit(f_.mask() & ~std::uint64_t{1}, [&](std::size_t at) {
      const auto& e = kSpace.exponents[at];
      const int k = i - e[p], l = j - e[q];
      const std::size_t c = e[axis_];
      if (k < 0 || l < 0) return;
      if (c == 0) {
        if (k == 0 && l == 0) h.put(to, h.has(to) ? T(h[to] + f_[at]) : f_[at]);
        return;
      }
      const std::size_t from = place(k, l);
      if (powers_[c].has(from) && !(c == 1 && from == to)) add(h, to, f_[at], powers_[c][from]);
    });
  }

  const Surface& f_;
  std::size_t axis_;
  std::array<Coefficients, Order + 1> powers_;  ///< of h, from the first
};

}  // namespace crest::smooth_ridges
