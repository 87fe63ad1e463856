// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Data that are small integers times one power of two (quantised measurements, images): equal
// values are then common, and native integers decide them.
#include <bit>
#include <cmath>
#include <limits>

#include "certify/reeb/checks.hpp"

namespace crest::certify::reeb {

__extension__ using Wide = __int128;

/// All data are n 2^e with |n| <= B. In units of 2^e a node's value is p / q with integers
///   vertex        |p| <= B,        q = 1;
///   line-critical d_a, d_b <= 8 B: |q| = 2 |d_a - d_b| <= 2^5 B,  |p| = |a q + d_a^2| <= 2^7 B^2;
///   face-critical g, h <= 8 B and P, Q, R <= 2^4 B: H <= 2^9 B^2, |q| = 2 |H| <= 2^10 B^2, weights
///   at most 2^8 B^2, |p| = |f0 q + g w1 + h w2| <= (2^10 + 2^11 + 2^11) B^3 <= 2^13 B^3.
/// So a product of two has |p q'| <= 2^23 B^5, and two different values differ by at least
/// 1 / (q q') >= 2^-20 B^-4.
struct Grid {
  bool fits = false;      ///< B <= 2^20: the products' difference is below 2^127
  double scale = 1;       ///< 2^-e: data times scale are the integers, exactly
  double separation = 0;  ///< values in an interval shorter than this are equal
};

inline Grid find_grid(const ReebContents& c) {
  constexpr int kMost = 20;
  int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
  for (const auto* list : {&c.values, &c.edge_values})
    for (const double x : *list) {
      if (x == 0) continue;
      const auto bits = std::bit_cast<std::uint64_t>(x);
      const auto exponent = static_cast<int>(bits >> 52 & 0x7ff);
      if (exponent == 0) return {};
      // |x| = (2^52 + fraction) 2^(exponent - 1075) < 2^(exponent - 1022).
      const std::uint64_t integer = (bits & ((std::uint64_t{1} << 52) - 1)) | std::uint64_t{1}
                                                                                  << 52;
      low = std::min(low, exponent - 1075 + std::countr_zero(integer));
      high = std::max(high, exponent - 1022);
      if (high - low > kMost) return {};
    }
  if (low > high) low = high = 0;  // all data are zero
  if (low < -900 || high > 900) return {};
  return {true, std::ldexp(1.0, -low), std::ldexp(1.0, low - 20 - 4 * (high - low))};
}

}  // namespace crest::certify::reeb
