// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A ray's way through the tetrahedra (SPEC.md, steps 2 to 4).
#include "certify/spline_rays/zeros.hpp"

namespace crest::certify::spline_rays {

/// Why a ray's record is wrong; null if it is true. `hit` is null for a miss. Cost: some
/// 20 microseconds a ray through 64 cubes; rationals where intervals do not decide.
const char* objection(const Scene& scene, const std::array<double, 6>& ray, const SplineHit* hit);

}  // namespace crest::certify::spline_rays
