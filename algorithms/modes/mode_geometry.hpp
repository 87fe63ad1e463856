// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Normals and principal curvatures of a mode surface inside one tet, in closed form from the
// gradient and the Hessian of the mode. The field is only continuous across faces: there the
// surface has creases, and both tets have their own answer.
#include <array>

#include "algorithms/modes/degenerate_result.hpp"

namespace crest::modes {

struct ModeGeometry {
  double mode;
  kernel::Vec3 gradient;  ///< of the mode in space
  kernel::Vec3 normal;    ///< the gradient's direction
  /// Of the surface mode = const: k1 >= k2, positive where it bends towards the normal (a sphere
  /// seen from outside, the mode growing outwards, has negative ones).
  double k1, k2;
  kernel::Vec3 d1, d2;
};

/// Requires: a tet of positive volume, T not zero and not degenerate at the point (a gradient).
ModeGeometry mode_geometry(const std::array<kernel::Vec3, 4>& corners,
                           const std::array<Tensor, 4>& tensors,
                           const std::array<double, 4>& weights);

}  // namespace crest::modes
