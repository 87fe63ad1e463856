// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The pieces glued along arcs: components, Euler characteristics, boundary loops (SPEC.md).
#include "certify/modes/cells.hpp"

namespace crest::certify::modes {

/// Of the + and the - level.
struct LevelSurfaces {
  SurfaceCounts positive, negative;
  u32 cones = 0, fans = 0;  ///< pieces at vertices and edges where the tensor is zero
};

/// Requires: all edges, faces and cells have been checked. Throws Reject.
LevelSurfaces glue_pieces(const LevelContext& context, const Domain& domain,
                          const std::vector<CellPieces>& cells);

}  // namespace crest::certify::modes
