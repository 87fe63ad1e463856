// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What jets are made with: where coefficients stand and where their products go, at compile time;
// what jets ask of number types.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "kernel/arithmetic/defined.hpp"
#include "kernel/arithmetic/monomials.hpp"

namespace crest::kernel {

/// The number x; `like`, if any, has the precision wanted. Types of run-time precision overload it.
template <class T>
T number_like(double x, const T* /*like*/) {
  return T(x);
}
/// sum += a b. Types that do this faster in one step overload it.
template <class T>
void add_product(T& sum, const T& a, const T& b) {
  sum = sum + a * b;
}

/// What a T is scaled by: a double, or T if it is built in.
template <class T>
struct ScalarOf {
  using Type = std::conditional_t<std::is_floating_point_v<T>, T, double>;
};

template <int Variables, int Order>
struct JetTables {
  using Table = Monomials<Variables, Order>;
  static constexpr int kCount = Table::kCount;
  static constexpr Table kMonomials{};

  std::array<std::array<std::uint8_t, kCount>, kCount> product{};  ///< of i and j, degree <= Order
  std::array<std::uint8_t, kCount> degree{};
  /// Bits of the monomials of degree at most d.
  std::array<std::uint64_t, Order + 1> up_to{};
  /// By the exponents as digits in base Order + 1; kCount beyond Order.
  std::array<std::uint8_t, Variables == 1   ? Order + 1
                           : Variables == 2 ? (Order + 1) * (Order + 1)
                                            : (Order + 1) * (Order + 1) * (Order + 1)>
      position{};

  constexpr JetTables() {
    for (std::uint8_t& p : position) p = kCount;
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto& e = kMonomials.exponents[i];
      degree[i] = static_cast<std::uint8_t>(Table::degree(e));
      std::size_t digits = 0;
      for (const std::size_t x : e) digits = digits * (Order + 1) + x;
      position[digits] = static_cast<std::uint8_t>(i);
      for (std::size_t d = degree[i]; d <= Order; ++d) up_to[d] |= std::uint64_t{1} << i;
    }
    for (const auto& [i, j, k] : kMonomials.products) product[i][j] = k;
  }

  /// Requires: as many exponents as variables, none negative, their sum at most Order.
  template <class... Exponents>
  static constexpr std::size_t digits(Exponents... exponents) {
    static_assert(sizeof...(exponents) == Variables);
    std::size_t result = 0;
    ((result = result * (Order + 1) + static_cast<std::size_t>(exponents)), ...);
    return result;
  }
};

}  // namespace crest::kernel
