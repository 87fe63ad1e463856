// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surface net of the sign changes of a function on a grid: a vertex for each sheet in a cell, at
// the mean of the crossings of its edges, a polygon around each edge that changes sign: of the four
// cells around it, or of three where one is larger (Gibson 1998; with sheets told apart: Nielson
// 2004; on octrees: Schaefer, Ju, Warren 2007). Where the signs around a side change more than
// twice, each run of negative corners is separated, from both cells alike.
//
// So the net is a closed surface for any graded grid: its edges are the joined pairs of crossings
// on sides, each between two polygons, and a vertex's polygons follow a loop of such pairs around
// its cell. Two pairs may join the same two vertices: the caller looks, and refines there.
#include <optional>

#include "algorithms/smooth_ridges/graded_grid.hpp"

namespace crest::smooth_ridges {

struct SurfaceNet {
  std::vector<Vec3> points;
  std::vector<double> cells;        ///< for each point the side of its cell
  std::vector<Triangle> faces;      ///< counter-clockwise seen from F >= 0
  std::optional<Vec3> on_boundary;  ///< a sign change of F on the box's boundary
  Vec3 low, high;                   ///< of the vertices, along the generic axes
};

/// F is taken at the nearest point of the box: outside, signs change only beside a zero of F on the
/// box's boundary.
SurfaceNet surface_net(Projection& f, const Surface::Box& box, const Grid& grid,
                       const std::vector<FineSpot>& spots = {});

}  // namespace crest::smooth_ridges
