// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which degenerate points of a tetrahedron's faces are joined inside it (SPEC.md).
#include "certify/modes_curves/face_points.hpp"

namespace crest::certify::curves {

/// A point on the face opposite to a corner.
struct TetPoint {
  FacePoint point;
  unsigned opposite;
};

/// Pairs of places in `points`; nothing where the tensors are dependent, or the conic is a pair of
/// lines that meet in the closed tetrahedron.
std::optional<std::vector<std::array<std::size_t, 2>>> find_arcs(modes::ExactTensors& exact,
                                                                 const std::array<u32, 4>& corners,
                                                                 std::vector<TetPoint>& points);

}  // namespace crest::certify::curves
