// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Elliptic or hyperbolic, by fourth- and by third-order quantities.
#include "algorithms/ridges/edge_states.hpp"

namespace crest::ridges {

struct TypeCounts {
  StageCounts crossing, segment;
};

/// kernel/predicates/crossing_type.hpp on a mesh edge: flat, elliptic or hyperbolic.
RidgeType fourth_order_type(const kernel::TriangleMesh& mesh,
                            const std::vector<kernel::MongeForm>& forms, Index edge, Colour colour,
                            TypeCounts& counts);

/// The det rule (kernel/predicates/segment_type.hpp) on the triangle between two crossed edges:
/// elliptic, hyperbolic, or flat when the three votes cancel. Requires: the edges bound one
/// triangle.
RidgeType third_order_type(const kernel::TriangleMesh& mesh,
                           const std::vector<kernel::MongeForm>& forms, const EdgeStates& states,
                           Index edge, Index next, Colour colour, TypeCounts& counts);

}  // namespace crest::ridges
