// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Is a triangle's area exactly zero?
//
// collinear(a, b, c) is true iff the three points lie on one line (or coincide), decided exactly.
// Laws. (1) symmetric in its arguments. (2) true when two are equal. (3) invariant under scaling
// by powers of two (barring overflow). Not true: that a false answer makes the triangle well
// shaped.
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// One coordinate of (b - a) x (c - a), from the other two coordinates.
struct CrossCoordinate {
  double ax, ay, bx, by, cx, cy;
  /// Differences 1, product 1 + 1 + 2, difference 1.
  static constexpr int depth = 5;
  template <class T>
  T value() const {
    return (T(bx) - T(ax)) * (T(cy) - T(ay)) - (T(by) - T(ay)) * (T(cx) - T(ax));
  }
};

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace crest::kernel
