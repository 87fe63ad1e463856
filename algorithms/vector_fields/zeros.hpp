// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The zero set: inside triangles, and its components at vertices, on edges, lines and at the border
// of regions without flow. All decided exactly.
#include "algorithms/vector_fields/domain.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"

namespace crest::vector_fields {

/// A component and the triangles that meet it.
struct ZeroComponent {
  CriticalPoint item;
  std::vector<Index> triangles;  ///< ascending
  HalfEdge place = kNone;        ///< vertex: a half-edge of its fan that leaves it; edge: it
  bool at_boundary = false;
};

/// By their least triangles. Cost: O(T) and exact work at ties.
std::vector<ZeroComponent> find_zeros(const Domain& domain);

/// +1, 0, -1: what the triangle adds to the index of the zeros it meets.
int symbolic_index(const Domain& domain, Index t);

/// Jacobian of the field in a triangle, xx xy yx yy, in doubles.
std::array<double, 4> jacobian(const Domain& domain, Index t);

/// In doubles.
kernel::Vec2 zero_in_triangle(const kernel::FieldOnTriangle& data);

}  // namespace crest::vector_fields
