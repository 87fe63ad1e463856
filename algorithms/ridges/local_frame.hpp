// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The coordinates a jet is fitted in.
#include <array>
#include <vector>

#include "algorithms/ridges/lanes.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::ridges {

/// Orthonormal rows x, y, z; origin at the neighbourhood's first point; lengths divided by scale.
struct LocalFrame {
  kernel::Vec3 x, y, z;
  double scale;
};

/// z is the direction of least variance of the first fit's points (as in CGAL's jet fitting), on
/// the side of the vertex normal; when the two disagree by more than 60 degrees (a thin or noisy
/// part, where least variance is no tangent plane) z is the vertex normal itself. scale is the root
/// mean square distance from the origin, 1 for a single point. Shapes: around[j], normals[j] belong
/// to lane j; around[j] is empty in a lane that is not used. Writes the local coordinates of all
/// points to local.
std::array<LocalFrame, kLanes> local_frames(const std::vector<kernel::Vec3>& points,
                                            const std::array<Support, kLanes>& around,
                                            const std::array<kernel::Vec3, kLanes>& normals,
                                            NeighbourhoodLanes& local);

/// Unit vertex normals: sums of the incident faces' normals, weighted by area.
std::vector<kernel::Vec3> vertex_normals(const kernel::TriangleMesh& mesh);

}  // namespace crest::ridges
