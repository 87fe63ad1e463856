// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The 128 directions of certify/ridges_smooth/SPEC.md: points of a square, exact, one of each
// opposite pair.
#include <array>
#include <cmath>
#include <cstdint>

namespace crest::smooth_ridges {

inline std::array<double, 2> direction(std::uint8_t k) {
  return k < 64 ? std::array<double, 2>{32, k - 32.0} : std::array<double, 2>{96.0 - k, 32};
}

/// The nearest one to +-(x, y) along the square. Requires: not both zero.
inline std::uint8_t nearest_direction(double x, double y) {
  const long k =
      std::fabs(x) >= std::fabs(y) ? 32 + std::lround(32 * y / x) : 96 - std::lround(32 * x / y);
  return static_cast<std::uint8_t>(k % 128);
}

}  // namespace crest::smooth_ridges
