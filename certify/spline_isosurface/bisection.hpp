// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rule of bisection (SPEC.md, "Leaves"). Points are integers, a cube's side is 2 kScale.
#include <cstdint>

#include "certify/exact/type6.hpp"

namespace crest::certify::spline_isosurface {

/// Every third bisection halves an edge, so kDepth of them divide by 2^20 at most.
inline constexpr unsigned kDepth = 60;
inline constexpr std::int64_t kScale = std::int64_t{1} << 20;

using Point = std::array<std::int64_t, 3>;

struct Simplex {
  std::array<Point, 4> corners;
  unsigned tag;  ///< 0: a tetrahedron of the partition; else the edge x0 x_tag is bisected
};

/// The sum of two coordinates of a simplex above the deepest level is even.
inline Point middle(const Point& a, const Point& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// A tetrahedron of the cube with this lowest corner, in lattice units.
inline Simplex root(const Point& cube, unsigned number) {
  Simplex simplex{{}, 0};
  const auto vertices = tetrahedron(number).vertices();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t d = 0; d < 3; ++d)
      simplex.corners[i][d] = kScale * (cube[d] + 1 + vertices[i][d]);
  return simplex;
}

/// One half of a simplex.
inline Simplex child(const Simplex& parent, bool second) {
  const auto& x = parent.corners;
  if (parent.tag == 0) {
    const auto& [c, a, b, d] = x;
    return {{c, d, middle(a, b), second ? b : a}, 3};
  }
  const unsigned tag = parent.tag;
  Simplex half = parent;
  half.tag = tag == 1 ? 3 : tag - 1;
  for (unsigned i = 0; second && i < tag; ++i) half.corners[i] = x[i + 1];
  half.corners[tag] = middle(x[0], x[tag]);
  return half;
}

}  // namespace crest::certify::spline_isosurface
