// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surface net of the sign changes of a function on a grid: a vertex for each sheet in a cell, at
// the mean of the crossings of its edges, a quadrangle around each grid edge that changes sign
// (Gibson 1998; with sheets told apart: Nielson 2004). Where the signs of a cell's side alternate,
// its negative corners are separated, from both cells alike.
#include <optional>

#include "algorithms/smooth_ridges/projection.hpp"

namespace crest::smooth_ridges {

/// Cells of side `cell` along three orthonormal axes; point (i, j, k) is origin + cell (i a0 +
/// ...).
struct Grid {
  Vec3 origin;
  std::array<Vec3, 3> axes;
  double cell;
  std::array<std::size_t, 3> points;  ///< along each axis

  std::size_t size() const { return points[0] * points[1] * points[2]; }
  Vec3 at(double i, double j, double k) const {
    return origin + cell * i * axes[0] + cell * j * axes[1] + cell * k * axes[2];
  }
};

/// A grid turned by a fixed rotation, and shifted, so that no symmetric surface is symmetric to it;
/// covers the points low..high measured along its axes.
Grid generic_grid(const Vec3& low, const Vec3& high, double cell);
/// The coordinates of a point along the axes of generic_grid().
Vec3 along_generic_axes(const Vec3& p);

struct SurfaceNet {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;      ///< counter-clockwise seen from F >= 0
  std::optional<Vec3> on_boundary;  ///< a sign change of F on the box's boundary
  Vec3 low, high;                   ///< of the vertices, along the generic axes
};

/// F is taken at the nearest point of the box: outside, signs change only beside a zero of F on the
/// box's boundary.
SurfaceNet surface_net(Projection& f, const Surface::Box& box, const Grid& grid);

}  // namespace crest::smooth_ridges
