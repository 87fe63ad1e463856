// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exact frames of an implicit surface's faces (certify/SPEC.md, claim 4, Forms): from three small
// integers three orthogonal integer vectors of one length, the third close to the normal. In such
// coordinates slopes are small, and E loses nothing by cancellation.
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::smooth_ridges {

/// The quaternion a + b i + c j.
using Frame = std::array<std::int8_t, 3>;

/// p, q, m: images of the axes under the quaternion's rotation, times its squared norm n; exact.
inline std::array<kernel::Vec3, 3> frame_vectors(const Frame& f) {
  const double a = f[0], b = f[1], c = f[2];
  return {kernel::Vec3{a * a + b * b - c * c, 2 * b * c, -2 * a * c},
          kernel::Vec3{2 * b * c, a * a - b * b + c * c, 2 * a * b},
          kernel::Vec3{2 * a * c, -2 * a * b, a * a - b * b - c * c}};
}

/// The frame whose m is close to the unit vector n.
inline Frame nearest_frame(const kernel::Vec3& n) {
  constexpr double kSize = 15;
  const double a = std::sqrt(std::fmax(0, (1 + n[2]) / 2));
  if (a < 0.05) return {0, 1, 0};
  const auto rounded = [](double x) { return static_cast<std::int8_t>(std::lround(kSize * x)); };
  return {rounded(a), rounded(-n[1] / (2 * a)), rounded(n[0] / (2 * a))};
}

}  // namespace crest::smooth_ridges
