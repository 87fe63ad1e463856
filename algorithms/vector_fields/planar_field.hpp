// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the system computes from: a plane vector field, linear on each triangle.
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::vector_fields {

using kernel::Index;
using kernel::kNone;
using kernel::Vec2;

struct PlanarField {
  std::vector<Vec2> points;
  std::vector<Vec2> vectors;  ///< one a point
  std::vector<kernel::Triangle> triangles;
};

}  // namespace crest::vector_fields
