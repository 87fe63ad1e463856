// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Smoothing of the extremalities (the idea of Hildebrandt, Polthier and Wardetzky 2005, section 4:
// smooth the function whose zeros are the ridges, not the surface).
#include <vector>

#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {

/// Replaces b0 and b3 at every vertex, `steps` times at once for all vertices, by the mean of its
/// own value and the average over its neighbours, whose frames are first oriented by the acute
/// rule.
void smooth_extremalities(const kernel::TriangleMesh& mesh, std::vector<kernel::MongeForm>& forms,
                          int steps);

}  // namespace crest::ridges
