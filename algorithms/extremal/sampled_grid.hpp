// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes and images as they are read, for the extraction and back.
#include "algorithms/extremal/extremal.hpp"
#include "kernel/geometry/sampled_grid.hpp"

namespace crest::extremal {

/// The samples as the extraction takes them: exactly, in the narrower real type that holds them.
Volume volume_of(const kernel::SampledGrid& grid);

/// From the grid's own frame.
void move_to_world(const kernel::SampledGrid& grid, Result& result);

}  // namespace crest::extremal
