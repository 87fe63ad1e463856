// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Creases: edges whose faces' normals make an angle above 40 degrees, joined at their ends to lines
// or nets of at least 30 edges. There k grows as the support shrinks, so a crease is a crest line
// by itself (salience.hpp), and fits that reach it take the smallest support. Shorter ones are what
// coarse or noisy meshes have everywhere. A statistic, compared in doubles like z.
#include <cstdint>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::ridges {

/// The least number of points of a support, and of edges of a crease.
inline constexpr int kSmallestSupport = 30;

/// Shapes: V; 1: an end of a crease's edge. Cost: O(E).
std::vector<std::uint8_t> crease_vertices(const kernel::TriangleMesh& mesh);

}  // namespace crest::ridges
