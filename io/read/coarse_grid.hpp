// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Coordinates that look rounded, as those of float32 far from the origin.
#include <optional>
#include <string>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// A line about them, or nothing. The rule: along an axis on which the coordinates differ, all are
/// whole multiples of a power of two or (as decimals) of ten, g, with g > h / 1024 and g > 4 h^3 /
/// L^2; h is the median length of the faces' first sides, L half the diagonal of the bounding box.
/// Lattices are meant to be so: not where g >= h / 2, unless a coordinate is beyond 2^20 g. The
/// line names the largest g of all axes. Reason: rounding by g changes what is fitted for third
/// derivatives by about g / h^3, and a smooth surface has about 1 / L^2. Ellipsoids 1, 1.5, 2 of
/// 600 to 40 000 vertices keep their four umbilics below that and lose them from 2 to 4 times as
/// much on.
std::optional<std::string> coarse_grid(const kernel::TriangleMesh& mesh);

}  // namespace crest::io
