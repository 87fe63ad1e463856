// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The first stages of faces and tetrahedra: doubles with errors, then pairs of doubles. Where these
// say nothing, integers decide (face_points.hpp, tet_arcs.hpp).
#include <optional>
#include <span>
#include <vector>

#include "certify/modes_curves/box.hpp"
#include "certify/modes_curves/wide_ball.hpp"

namespace crest::certify::curves {

/// A degenerate tensor of a face and its eigenvector v, up to a factor.
struct NearPoint {
  int type;    ///< +1 linear, -1 planar
  u32 listed;  ///< place among the listed points
  std::array<WideBall, 3> v;
};

/// A point on the face opposite to a corner of a tetrahedron.
struct NearTetPoint {
  const NearPoint* point;
  unsigned opposite;
};

template <std::size_t n>
using Corners = std::array<const std::array<double, 6>*, n>;

/// All degenerate tensors of the closed face: they are inside, each in its box.
std::optional<std::vector<NearPoint>> find_near_points(const Corners<3>& tensors,
                                                       const std::vector<Box>& boxes);

/// Pairs of places in `points`, joined by curves in the tetrahedron.
/// Requires: an even number of points, not 0.
std::optional<std::vector<std::array<std::size_t, 2>>> find_near_arcs(
    const Corners<4>& tensors, std::span<const NearTetPoint> points);

}  // namespace crest::certify::curves
