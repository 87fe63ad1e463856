// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is counted on the triangles of a surface.
#include <functional>

#include "algorithms/modes/mode_surface.hpp"

namespace crest::modes {

/// Splits vertices whose triangles form several fans (two blocks that touch in an edge, cones with
/// one apex for each component of the link), turns the triangles of a component alike, fills in
/// components, Euler characteristic, boundary loops. Returns the edges of one triangle.
/// Throws: std::logic_error for an edge of three triangles.
std::vector<std::array<kernel::Index, 2>> count(ModeSurface& surface);

}  // namespace crest::modes
