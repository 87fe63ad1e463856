// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Coordinates that look rounded, as those of float32 far from the origin.
#include <optional>
#include <string>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// Parts of an edge below which rounding does no harm to curvatures worth a word.
inline constexpr double kFinestGrid = 64;

/// A line about them, or nothing. The rule: along an axis on which the coordinates differ, all are
/// whole multiples of a power of two or (as decimals) of ten, g, and g > h / 64, h being the median
/// of the lengths of the faces' first sides. Lattices are meant to be so: not where g >= h / 2,
/// unless a coordinate is beyond 2^20 g. The line names the largest g of all axes.
std::optional<std::string> coarse_grid(const kernel::TriangleMesh& mesh);

}  // namespace crest::io
