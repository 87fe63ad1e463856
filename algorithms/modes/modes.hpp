// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public calls of this system (theory and limits: README.md beside this file).
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::modes {

/// What the system computes from: tetrahedra.
struct Input {
  std::vector<kernel::Vec3> points;
  std::vector<std::array<std::uint32_t, 4>> cells;  ///< by their corners
};

struct Census {
  std::uint32_t distinct = 0;  ///< places with a point
  std::uint32_t used = 0;      ///< points that are corners of cells
};

/// Counts the input's points. Requires: finite points, corners below their number.
/// Cost: O(V log V + C).
Census take_census(const Input& input);

}  // namespace crest::modes
