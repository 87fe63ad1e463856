// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The indices of Bernstein polynomials on simplices and boxes, in a fixed order.
//
// Simplex with corners 0..Dim: index a = (a_0, ..., a_Dim) with sum Degree, the coefficient of
// Degree! / (a_0! ... a_Dim!) l_0^a_0 ... l_Dim^a_Dim. Order: decreasing a_0, then decreasing a_1,
// and so on; so a segment reads from corner 0 to corner 1, a triangle's quadratic 00 01 02 11 12 22
// (corner pairs). The position depends on a_1, ..., a_Dim only, not on the degree.
//
// Box: index (a_0, a_1, ...), 0 <= a_k <= N_k, the coefficient of the product over the axes of
// C(N_k, a_k) x_k^a_k (1 - x_k)^(N_k - a_k). Order: axis 0 runs fastest.
#include <array>
#include <cstddef>
#include <cstdint>

namespace crest::kernel {

constexpr std::size_t choose(std::size_t n, std::size_t k) {
  if (k > n) return 0;
  std::size_t r = 1;
  for (std::size_t i = 1; i <= k; ++i) r = r * (n - k + i) / i;
  return r;
}

template <int Dim, int Degree>
struct SimplexBasis {
  static_assert(Dim >= 1 && Degree >= 0 && Degree < 40);
  static constexpr int dim = Dim, degree = Degree;
  static constexpr std::size_t corners = Dim + 1;
  static constexpr std::size_t count = choose(Degree + Dim, Dim);
  using Index = std::array<std::uint8_t, corners>;

  static constexpr std::size_t position(const Index& a) {
    std::size_t rest = Degree, r = 0;
    for (std::size_t k = 0; k < Dim; ++k) {
      rest -= a[k];
      const std::size_t axes = Dim - k;
      r += rest == 0 ? 0 : choose(rest - 1 + axes, axes);
    }
    return r;
  }
  static constexpr std::array<Index, count> make_indices() {
    std::array<Index, count> r{};
    Index a{};
    a[0] = Degree;
    for (std::size_t i = 0; i < count; ++i) {
      r[i] = a;
      if (i + 1 == count) break;
      // The last corner before Dim that has some gives one to the next, which takes all behind it.
      std::size_t k = Dim - 1;
      while (a[k] == 0) --k;
      const std::uint8_t tail = a[Dim];
      a[Dim] = 0;
      --a[k];
      a[k + 1] = static_cast<std::uint8_t>(tail + 1);
    }
    return r;
  }
  static constexpr std::array<Index, count> indices = make_indices();
  /// Degree! / (a_0! ... a_Dim!), exact in doubles up to degree 18.
  static constexpr std::array<double, count> make_weights() {
    std::array<double, count> r{};
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t rest = Degree, w = 1;
      for (std::size_t k = 0; k < Dim; ++k) {
        w *= choose(rest, indices[i][k]);
        rest -= indices[i][k];
      }
      r[i] = static_cast<double>(w);
    }
    return r;
  }
  static constexpr std::array<double, count> weights = make_weights();
  static constexpr std::size_t corner(std::size_t i) {
    Index a{};
    a[i] = Degree;
    return position(a);
  }
};

template <int... N>
struct BoxBasis {
  static_assert(sizeof...(N) >= 1);
  static constexpr int dim = sizeof...(N);
  static constexpr std::array<std::size_t, dim> degrees = {N...};
  static constexpr std::size_t corners = std::size_t{1} << dim;
  static constexpr std::size_t count = (std::size_t{N + 1} * ...);
  using Index = std::array<std::uint8_t, dim>;

  static constexpr std::size_t stride(std::size_t axis) {
    std::size_t r = 1;
    for (std::size_t k = 0; k < axis; ++k) r *= degrees[k] + 1;
    return r;
  }
  static constexpr std::size_t position(const Index& a) {
    std::size_t r = 0;
    for (std::size_t k = 0; k < a.size(); ++k) r += a[k] * stride(k);
    return r;
  }
  static constexpr std::array<Index, count> make_indices() {
    std::array<Index, count> r{};
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < degrees.size(); ++k)
        r[i][k] = static_cast<std::uint8_t>(i / stride(k) % (degrees[k] + 1));
    return r;
  }
  static constexpr std::array<Index, count> indices = make_indices();
  static constexpr std::array<double, count> make_weights() {
    std::array<double, count> r{};
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t w = 1;
      for (std::size_t k = 0; k < degrees.size(); ++k) w *= choose(degrees[k], indices[i][k]);
      r[i] = static_cast<double>(w);
    }
    return r;
  }
  static constexpr std::array<double, count> weights = make_weights();
  /// Corner i has coordinate 1 on the axes of i's bits.
  static constexpr std::size_t corner(std::size_t i) {
    Index a{};
    for (std::size_t k = 0; k < degrees.size(); ++k)
      a[k] = static_cast<std::uint8_t>((i >> k & 1) * degrees[k]);
    return position(a);
  }
};

/// The basis of products.
template <class A, class B>
struct ProductBasis;
template <int Dim, int M, int N>
struct ProductBasis<SimplexBasis<Dim, M>, SimplexBasis<Dim, N>> {
  using type = SimplexBasis<Dim, M + N>;
};
template <int... M, int... N>
struct ProductBasis<BoxBasis<M...>, BoxBasis<N...>> {
  using type = BoxBasis<(M + N)...>;
};

}  // namespace crest::kernel
