// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The monomials of truncated polynomials and which of them multiply to which: tables for jets and
// Taylor models, made at compile time.
#include <array>
#include <cstdint>

namespace crest::kernel {

constexpr int monomial_count(int variables, int order) {
  int count = 1;
  for (int i = 1; i <= variables; ++i) count = count * (order + i) / i;
  return count;
}

/// The monomials of total degree <= Order by ascending degree, and their products.
template <int Variables, int Order>
struct Monomials {
  static constexpr int kCount = monomial_count(Variables, Order);
  static constexpr int kProducts = monomial_count(2 * Variables, Order);
  using Exponents = std::array<std::uint8_t, Variables>;

  std::array<Exponents, kCount> exponents{};
  std::array<std::array<std::uint8_t, 3>, kProducts> products{};

  static constexpr int degree(const Exponents& e) {
    int sum = 0;
    for (int x : e) sum += x;
    return sum;
  }
  constexpr int find(const Exponents& e) const {
    for (int i = 0; i < kCount; ++i) {
      bool same = true;
      for (std::size_t v = 0; v < Variables; ++v)
        same = same && exponents[static_cast<std::size_t>(i)][v] == e[v];
      if (same) return i;
    }
    return -1;
  }
  constexpr Monomials() {
    std::size_t next = 0;
    for (int d = 0; d <= Order; ++d) {
      Exponents e{};
      for (;;) {  // counts e up, last variable fastest
        if (degree(e) == d) exponents[next++] = e;
        int v = Variables - 1;
        while (v >= 0 && e[static_cast<std::size_t>(v)] == d) e[static_cast<std::size_t>(v--)] = 0;
        if (v < 0) break;
        ++e[static_cast<std::size_t>(v)];
      }
    }
    next = 0;
    for (std::uint8_t i = 0; i < kCount; ++i)
      for (std::uint8_t j = 0; j < kCount; ++j) {
        Exponents e = exponents[i];
        for (std::size_t v = 0; v < Variables; ++v)
          e[v] = static_cast<std::uint8_t>(e[v] + exponents[j][v]);
        if (degree(e) <= Order) products[next++] = {i, j, static_cast<std::uint8_t>(find(e))};
      }
  }
};

}  // namespace crest::kernel
