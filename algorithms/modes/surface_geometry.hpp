// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Normals and principal curvatures at a mode surface's points (mode_geometry.hpp).
#include "algorithms/modes/modes.hpp"

namespace crest::modes {

/// Fills surface.geometry; zeros in tetrahedra without volume and where the mode has no gradient.
void add_geometry(const ModeField& field, ModeSurface& surface);

}  // namespace crest::modes
