// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The flow across the boundary: runs of inflow, outflow and tangency, and the switch points between
// them; the index relation. All decided exactly.
//
// On an edge of the boundary, the domain at its left, det(edge, v) is linear: the signs at its ends
// decide. Around a loop these signs, two an edge, stand in a circle; where two that are not zero
// differ with nothing or only tangency between, there is a switch point.
#include <unordered_map>

#include "algorithms/vector_fields/domain.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"
#include "algorithms/vector_fields/zeros.hpp"

namespace crest::vector_fields {

/// Regions at the ends of a boundary edge; they differ if it switches inside. On each loop switch
/// points and runs with zeros are events; region r follows event r, and the loop's start lies in
/// the last one.
struct EdgeRegions {
  Index at_from = kNone, at_to = kNone;  ///< kNone: tangent or zero there
};

struct Boundary {
  std::vector<std::vector<HalfEdge>> half_edges;  ///< by loops
  std::vector<BoundaryLoop> loops;
  std::vector<SwitchPoint> switch_points;
  std::unordered_map<HalfEdge, EdgeRegions> regions;  ///< inflow and outflow, over all loops
};

Boundary examine_boundary(const Domain& domain);

/// Turns of the vectors from a to b across the positive x-axis: 1, 0 or -1; their sum around a
/// cycle on which the field is not zero is its winding.
int axis_crossing(const Vec2& a, const Vec2& b);

/// The winding around all triangles that meet no zero at the boundary.
int winding_around(const Domain& domain, const Boundary& boundary,
                   const std::vector<ZeroComponent>& zeros);

}  // namespace crest::vector_fields
