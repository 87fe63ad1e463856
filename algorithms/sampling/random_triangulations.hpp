// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Random triangulations without places, to code and to test on.
#include <random>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::sampling {

/// A sphere of v >= 4 vertices: a tetrahedron, then each vertex in a random face.
std::vector<kernel::Triangle> stacked_sphere(kernel::Index v, std::mt19937_64& random);

/// Tries to flip so many random edges; those of the boundary and those that would make a doubled
/// edge stay. Requires: an oriented manifold. Cost: O(log F) a flip.
void flip_edges(std::vector<kernel::Triangle>& faces, kernel::Index vertices, std::size_t flips,
                std::mt19937_64& random);

}  // namespace crest::sampling
