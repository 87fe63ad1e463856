// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exact frames of an implicit surface's faces (certify/ridges_smooth/SPEC.md, Forms): from four
// small integers three orthogonal integer vectors of one length, the third close to the normal. In
// such coordinates slopes are small, and E loses nothing by cancellation.
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::smooth_ridges {

/// The quaternion e + f i + g j + h k.
using Frame = std::array<std::int8_t, 4>;

/// p, q, m: images of the axes under the quaternion's rotation, times its squared norm; exact.
inline std::array<kernel::Vec3, 3> frame_vectors(const Frame& frame) {
  const double e = frame[0], f = frame[1], g = frame[2], h = frame[3];
  return {kernel::Vec3{e * e + f * f - g * g - h * h, 2 * (f * g + e * h), 2 * (f * h - e * g)},
          kernel::Vec3{2 * (f * g - e * h), e * e - f * f + g * g - h * h, 2 * (g * h + e * f)},
          kernel::Vec3{2 * (f * h + e * g), 2 * (g * h - e * f), e * e - f * f - g * g + h * h}};
}

/// The frame whose m is close to the unit vector n.
inline Frame nearest_frame(const kernel::Vec3& n) {
  constexpr double kSize = 15;
  const double a = std::sqrt(std::fmax(0, (1 + n[2]) / 2));
  if (a < 0.05) return {0, 1, 0, 0};
  const auto rounded = [](double x) { return static_cast<std::int8_t>(std::lround(kSize * x)); };
  return {rounded(a), rounded(-n[1] / (2 * a)), rounded(n[0] / (2 * a)), 0};
}

}  // namespace crest::smooth_ridges
