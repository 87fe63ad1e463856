// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Critical points of the mode on the unit tensors of a face's plane (paper 004, equations 10 to
// 13), in plain doubles: for tests and pictures, nothing is decided by them. There are seven pairs
// +-T, complex ones counted; four are degenerate tensors, two or four of them real; by Euler's
// count degenerate points are the only extrema if all four are real, and with two at most one other
// is.
#include <array>
#include <vector>

#include "algorithms/modes/degenerate_result.hpp"

namespace crest::modes {

struct FaceCriticalPoint {
  std::array<double, 3> weights;  ///< sum 1 (infinite if the point is at infinity)
  double mode;                    ///< at the point
  bool degenerate;                ///< |mode| = 1 to rounding
  bool extremum;                  ///< of the mode on the sphere of unit tensors
};

/// All real ones. Requires: independent deviators.
std::vector<FaceCriticalPoint> face_critical_points(const std::array<Tensor, 3>& corners);

}  // namespace crest::modes
