// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The smallest change of a cubic spline in normal form that makes it C1.
#include "algorithms/splines/cubic_model.hpp"

namespace crest::splines {

/// Changes f and g of the vertices, then the slopes, each by as little as possible (sum of
/// squares), so that centres exist with which the spline is C1 up to rounding; the centres stay.
/// The equations' normal matrices are diagonal in sine transforms. Cost: n^4.
void project_to_c1(CubicModel& model);

}  // namespace crest::splines
