// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ridge graph of a refined surface (certify/ridges_smooth/SPEC.md, The graph; paper 002,
// section 6.3).
#include "algorithms/smooth_ridges/refinement.hpp"

namespace crest::smooth_ridges {

/// Fills umbilics, ridges, turning and purple points. Where faces are not certified ridges end
/// open.
void assemble_graph(const Surface& surface, const RefinedSurface& refined, SmoothRidges& out);

}  // namespace crest::smooth_ridges
