// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A smooth closed surface of any genus: a rounded plate with holes.
#include "algorithms/sampling/mesh_surface.hpp"

namespace crest::sampling {

/// The boundary of a bar of (2 genus + 1) x 3 x 1 unit cubes with a hole through every second one
/// along its middle, subdivided by Catmull and Clark's rule and cut into triangles; x runs along
/// the holes, centred at the origin. With rotate in a generic pose. No Monge forms. The number of
/// vertices is met within 30 % from 30 (18 genus + 14) on.
/// Requires: 0 <= genus <= 100. Throws: std::invalid_argument otherwise.
SurfaceSample sample_handles(int genus, int vertices, bool rotate);

}  // namespace crest::sampling
