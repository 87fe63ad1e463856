// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a spline has at a point.
#include "kernel/arithmetic/vec3.hpp"

namespace crest::splines {

/// Of the world; NaN, all of them, at a point outside of the domain.
struct ValueAndGradient {
  double value;
  kernel::Vec3 gradient;
};

}  // namespace crest::splines
