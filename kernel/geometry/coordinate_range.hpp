// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sizes of meshes whose curvatures and lengths doubles can carry.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::kernel {

/// Throws InputError, with the factor that mends it, if a coordinate is above 1e70 or the bounding
/// box below 1e-70: products of four lengths and their inverses must stay in the range of doubles,
/// with room for the mesh's size. Requires: finite coordinates.
inline void require_carried(const std::vector<Vec3>& points) {
  constexpr double largest = 1e70, smallest = 1e-70;
  if (points.empty()) return;
  double extent = 0, reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [k](const Vec3& p, const Vec3& q) { return p[k] < q[k]; });
    extent = std::max(extent, 0.5 * (*high)[k] - 0.5 * (*low)[k]);
    reach = std::max({reach, std::fabs((*low)[k]), std::fabs((*high)[k])});
  }
  const bool large = reach > largest;
  if (!large && extent >= smallest) return;
  const double size = large ? reach : std::max(extent, std::numeric_limits<double>::min());
  throw InputError("points: their coordinates are too " + std::string(large ? "large" : "small") +
                   " for curvatures and lengths; scale the mesh by 1e" +
                   std::to_string(-static_cast<int>(std::floor(std::log10(size)))));
}

}  // namespace crest::kernel
