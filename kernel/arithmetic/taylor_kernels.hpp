// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The inner loops of Taylor models, unrolled at compile time: products of truncated polynomials and
// the sums that bound what is left out. Order and bits are fixed: nothing is left to a vectoriser's
// choice of association.
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/arithmetic/taylor_series.hpp"

namespace crest::kernel::taylor {

/// Two doubles in one register.
using Pair [[gnu::vector_size(16)]] = double;
using PairBits [[gnu::vector_size(16)]] = long long;

inline Pair magnitudes(Pair x) {
  constexpr long long kNoSign = 0x7fff'ffff'ffff'ffff;
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(x) & PairBits{kNoSign, kNoSign});
}

template <int Order>
struct Kernels {
  static constexpr int kCount = monomial_count(2, Order);
  static constexpr Monomials<2, Order> kTable{};
  static constexpr Weights<Order> kWeights{};
  static constexpr double kUnit = 0x1p-53;
  /// What products of coefficients lose to underflow, for each unit of size: taylor_model.hpp, (c).
  static constexpr double kLost = 0x1p-1000;
  using Coefficients = std::array<double, kCount>;
  /// Most terms of a product's coefficient: u^i v^j has (i + 1)(j + 1), i + j <= Order.
  static constexpr int kTerms = (Order / 2 + 1) * ((Order + 1) / 2 + 1);

  /// The product truncated: each coefficient is the sum of at most kTerms products.
  static Coefficients product(const Coefficients& a, const Coefficients& b) {
    return product_of(a, b, std::make_index_sequence<kCount>{});
  }

  /// Sum of |a_m|.
  static double size(const Coefficients& a) {
    Pair even = {0, 0}, odd = {0, 0};
    std::size_t m = 0;
    for (; m + 3 < kCount; m += 4) {
      even += magnitudes(Pair{a[m], a[m + 1]});
      odd += magnitudes(Pair{a[m + 2], a[m + 3]});
    }
    for (; m < kCount; ++m) even[0] += std::fabs(a[m]);
    even += odd;
    return even[0] + even[1];
  }

  /// Sums of w |a_m| and of w |b_m|, and of w |a_l| w |b_m| over degrees that sum up to more than
  /// Order.
  struct Sizes {
    double a, b, beyond;
  };
  static Sizes sizes(const Coefficients& a, const Coefficients& b) {
    return sizes_of(a, b, std::make_index_sequence<Order>{});
  }

  /// What the product of the models (a, a_radius) and (b, b_radius) errs by: taylor_model.hpp, (a)
  /// and (b), before it is grown.
  static double left_out(const Coefficients& a, double a_radius, const Coefficients& b,
                         double b_radius) {
    constexpr double kSpread = 1 << (Order / 2);
    constexpr double kRounding = 1.02 * kSpread * kSpread * kTerms * kUnit;
    const Sizes size = sizes(a, b);
    return size.beyond + kRounding * size.a * size.b + size.a * b_radius + size.b * a_radius +
           a_radius * b_radius + kLost * (size.a + size.b);
  }

  /// Coefficient K of a product. List: what has coefficients.
  template <std::size_t K, class List>
  static double coefficient(const List& a, const List& b) {
    return coefficient_of<K>(a, b, std::make_index_sequence<count_terms<K>()>{});
  }

 private:
  template <std::size_t K>
  static constexpr int count_terms() {
    int n = 0;
    for (const auto& p : kTable.products) n += p[2] == K ? 1 : 0;
    return n;
  }
  template <std::size_t K>
  static constexpr auto list_terms() {
    std::array<std::array<std::uint8_t, 2>, count_terms<K>()> list{};
    std::size_t n = 0;
    for (const auto& p : kTable.products)
      if (p[2] == K) list[n++] = {p[0], p[1]};
    return list;
  }
  template <std::size_t K, class List, std::size_t... I>
  static double coefficient_of(const List& a, const List& b, std::index_sequence<I...>) {
    constexpr auto kList = list_terms<K>();
    return ((a[kList[I][0]] * b[kList[I][1]]) + ...);
  }
  template <std::size_t... K>
  static Coefficients product_of(const Coefficients& a, const Coefficients& b,
                                 std::index_sequence<K...>) {
    return {coefficient<K>(a, b)...};
  }

  /// Over the monomials of degree D: sum of w |a_m| and of w |b_m|.
  template <std::size_t D, std::size_t... I>
  static Pair of_degree(const Coefficients& a, const Coefficients& b, std::index_sequence<I...>) {
    constexpr std::size_t kFirst = D * (D + 1) / 2;
    return (weighted<kFirst + I>(Pair{a[kFirst + I], b[kFirst + I]}) + ...);
  }
  template <std::size_t M>
  static Pair weighted(Pair x) {
    constexpr double kWeight = kWeights.of[M];
    if constexpr (kWeight == 1) return magnitudes(x);
    return magnitudes(x) * Pair{kWeight, kWeight};
  }
  template <std::size_t... D>  // 0 to Order - 1
  static Sizes sizes_of(const Coefficients& a, const Coefficients& b, std::index_sequence<D...>) {
    const Pair degree[] = {
        of_degree<D + 1>(a, b, std::make_index_sequence<D + 2>{})...};  // from degree 1
    Pair from[Order];  // sums over degree d + 1 and above
    from[Order - 1] = degree[Order - 1];
    ((Order >= D + 2 ? void(from[Order - 2 - D] = degree[Order - 2 - D] + from[Order - 1 - D])
                     : void()),
     ...);
    const Pair all = magnitudes(Pair{a[0], b[0]}) + from[0];
    return {all[0], all[1], ((degree[D][0] * from[Order - 1 - D][1]) + ...)};
  }
};

}  // namespace crest::kernel::taylor
