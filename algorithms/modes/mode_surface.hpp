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
};

}  // namespace crest::modes
