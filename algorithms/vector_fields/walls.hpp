// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lines into walls. In a triangle with two zero corners all lines are straight, along the third
// corner's vector; towards the wall they reach it in infinite time.
#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

/// The component of which an open wall edge catches all lines that enter the side's triangle
/// between two of its points; nothing if there is none. Exact.
std::optional<Index> wall_ahead(const Surroundings& around, bool forward, HalfEdge side,
                                const Expansion& left, const Expansion& right);

/// The component that a triangle meets.
std::optional<Index> zero_of_triangle(const Surroundings& around, Index t);

}  // namespace crest::vector_fields
