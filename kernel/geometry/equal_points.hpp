// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points at the same place.
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::kernel {

/// For every point the first one that equals it; -0 equals 0. Requires: finite coordinates.
/// Cost: O(V) expected.
std::vector<Index> first_equal(const std::vector<Vec3>& points);

/// How many points equal one before them. Requires and cost: as above.
std::size_t count_equal(const std::vector<Vec3>& points);

}  // namespace crest::kernel
