// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points of a surface in the coordinates of certify/ridges_smooth/SPEC.md, Forms.
#include <array>
#include <cmath>

#include "algorithms/smooth_ridges/local_graph.hpp"
#include "algorithms/smooth_ridges/surface.hpp"

namespace crest::smooth_ridges {

/// A point of the surface in the coordinates of its axis (implicit) or in unit ones.
struct SurfacePoint {
  std::size_t axis = 0;       ///< of the graph; parametric: 0
  std::array<double, 2> z{};  ///< (p, q) or (U, V)
  double height = 0;          ///< along the axis; parametric: 0
};

/// The point of space with these coordinates.
inline Vec3 in_space(const SurfacePoint& p) {
  const auto [i, j] = plane_axes(p.axis);
  Vec3 x{};
  x[i] = p.z[0];
  x[j] = p.z[1];
  x[p.axis] = p.height;
  return x;
}

/// Moves p along its axis onto the implicit surface, by Newton's method; false if that fails.
inline bool settle(ImplicitMap<double, 1>& f, SurfacePoint& p) {
  for (int i = 0; i < 30; ++i) {
    const auto value = f(in_space(p));
    std::array<int, 3> unit{};
    unit[p.axis] = 1;
    const double step = value[0] / value.coefficient(unit[0], unit[1], unit[2]);
    if (!std::isfinite(step)) return false;
    p.height -= step;
    if (std::fabs(step) < 1e-15 * (1 + std::fabs(p.height))) return true;
  }
  return true;
}

}  // namespace crest::smooth_ridges
