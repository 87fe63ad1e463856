// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A level of the mode, |mu| = p / q, and what has its sign.
//
// With n = |T|^2, c = tr(T^3) = 3 det T: mode = sqrt(6) c / n^(3/2), and
//   f = 54 det^2 - mu^2 |T|^6 = 6 c^2 - mu^2 n^3   (mu = 0: f stands for det)
//   F = q^2 f, with integer coefficients           (mu = 0: F = 6 det = 2 c)
// A level's sides follow rule H3 of README.md: f = 0 counts as f > 0.
#include <cstdint>

#include "kernel/arithmetic/sign.hpp"

namespace crest::modes {

struct Level {
  std::int64_t p = 0, q = 1;  ///< in lowest terms, 0 <= p < q <= kLargest
  /// 54 q^2 stays exact in a double.
  static constexpr std::int64_t kLargest = 10'000'000;
  bool neutral() const { return p == 0; }
  double value() const { return static_cast<double>(p) / static_cast<double>(q); }
};

/// Which of a pair's surfaces: mode = +mu, -mu, or the neutral one.
enum class Side : std::int8_t { minus = -1, neutral = 0, plus = 1 };

/// The signs of f and det at a point.
struct PointSigns {
  kernel::Sign f = kernel::Sign::zero, det = kernel::Sign::zero;
};

/// Whether the point counts as above the surface (mode above its level).
inline bool is_above(const PointSigns& s, Side side) {
  const bool not_negative = s.f != kernel::Sign::negative;
  switch (side) {
    case Side::neutral:
      return not_negative;
    case Side::plus:
      return not_negative && s.det == kernel::Sign::positive;
    case Side::minus:
      break;
  }
  return !(not_negative && s.det == kernel::Sign::negative);
}

}  // namespace crest::modes
