// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sub- and superlevel sets of one quadratic triangle by conic geometry, in 128-bit integers: knows
// no tile. Requires: integer nodal values of magnitude up to 1000.
#include <array>
#include <cstddef>
#include <vector>

namespace crest::tests {

using Integer = __int128;

struct Fraction {
  Integer n = 0, d = 1;  // d > 0
  friend int compare(const Fraction& a, const Fraction& b) {
    const Integer x = a.n * b.d - b.n * a.d;
    return x < 0 ? -1 : x > 0;
  }
};
inline Fraction mediant(const Fraction& a, const Fraction& b) {
  return {a.n + b.n, a.d + b.d};
}

/// A corner (side = -1) or a side's extremum, at (x, y) / w, w > 0.
struct BoundaryNode {
  int corner, side;
  Fraction value;
  Integer x, y, w;
  bool saddle = false;  // a boundary saddle (sides only)
};

class QuadraticTriangle {
 public:
  /// Corner values, then those at the middles of c0 c1, c1 c2, c2 c0.
  explicit QuadraticTriangle(const std::array<int, 6>& nodal);

  const std::vector<BoundaryNode>& boundary() const { return boundary_; }
  bool has_centre_inside() const { return centre_ == 1; }
  const Fraction& centre_value() const { return centre_value_; }

  /// Are the boundary nodes i and j joined in {f <= c} (below) or {f >= c} of the triangle?
  /// Requires: both lie in that set.
  bool joined(std::size_t i, std::size_t j, const Fraction& c, bool below) const;

 private:
  bool beyond(std::size_t i, const Fraction& c, bool below) const;
  bool separated(std::size_t i, std::size_t j, const Fraction& c, bool below, int part) const;
  int part_of(std::size_t i, bool below) const;

  Integer a_, b_, c_, d_, e_, f_;  // a s^2 + b s t + c t^2 + d s + e t + f
  std::vector<BoundaryNode> boundary_;
  Integer hessian_;
  int centre_ = -1;  // in the open triangle 1, on its boundary 0, outside or none -1
  Integer centre_x_ = 0, centre_y_ = 0, centre_w_ = 1;
  Fraction centre_value_;
};

}  // namespace crest::tests
