// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The coordinates a jet is fitted in.
#include <span>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::ridges {

/// Orthonormal rows x, y, z; origin at the neighbourhood's first point; lengths divided by scale.
struct LocalFrame {
  kernel::Vec3 x, y, z, origin;
  double scale;
};

/// z is the direction of least variance of the points (as in CGAL's jet fitting), on the side of
/// vertex_normal; when the two disagree by more than 60 degrees (a thin or noisy part, where least
/// variance is no tangent plane) z is vertex_normal itself. scale is the root mean square distance
/// from the origin. Writes the points' local coordinates to local.
LocalFrame local_frame(const std::vector<kernel::Vec3>& points,
                       std::span<const kernel::Index> neighbourhood,
                       const kernel::Vec3& vertex_normal, std::vector<kernel::Vec3>& local);

/// Unit vertex normals: sums of the incident faces' normals, weighted by area.
std::vector<kernel::Vec3> vertex_normals(const kernel::TriangleMesh& mesh);

}  // namespace crest::ridges
