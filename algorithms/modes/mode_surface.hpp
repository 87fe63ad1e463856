// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Mode surfaces as triangle meshes with their counts: the result that writers see.
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::modes {

struct SurfaceComponent {
  std::int64_t euler_characteristic = 0;
  std::size_t boundary_loops = 0;
  bool orientable = true;
  bool complete = true;  ///< it touches no undecided cell: the counts are proven
};

/// Of the surface at a point, in closed form from the field of the tetrahedron of its first
/// triangle: the surface has creases between tetrahedra, over which nothing is averaged.
struct PointGeometry {
  kernel::Vec3 normal{};    ///< towards higher modes
  double k1 = 0, k2 = 0;    ///< k1 >= k2; positive where it bends towards the normal
  kernel::Vec3 d1{}, d2{};  ///< their directions
};

/// Exact hits, where the surface is that of an infinitesimally lower mode (rule H3).
struct Perturbed {
  std::size_t vertices = 0;      ///< of the mesh, which the level passes through
  std::size_t edge_touches = 0;  ///< places inside edges of the mesh that it touches from below
  std::size_t uniform_tets = 0;  ///< everywhere at |level|
};

/// The surface of one signed level.
struct ModeSurface {
  int sign = 0;     ///< of the level: 1, -1; 0: neutral
  double mode = 0;  ///< signed
  std::vector<kernel::Vec3> points;
  std::vector<std::array<kernel::Index, 3>> triangles;  ///< anticlockwise seen from above
  std::vector<kernel::Index> tets;                      ///< each triangle's
  std::vector<std::array<double, 6>> tensors;  ///< at the points: the deviator, VTK's order
  std::vector<SurfaceComponent> components;    ///< by their first triangle
  std::vector<kernel::Index> component_of;     ///< a triangle's
  std::int64_t euler_characteristic = 0;
  bool watertight = false;  ///< every edge off the domain's boundary has two triangles
  double max_mode_error = 0;
  std::size_t face_loops = 0;       ///< loops of the curve inside one face of the mesh
  std::size_t zero_rims = 0;        ///< boundary edges on edges of the field's zero set
  std::size_t unproven_pieces = 0;  ///< whose projections were not found simple and nested
  std::vector<kernel::Vec3> singular_points;
  Perturbed perturbed;
  std::vector<PointGeometry> geometry;  ///< at the points; empty: not asked for
};

}  // namespace crest::modes
