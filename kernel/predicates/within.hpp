// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Are two points within a distance of each other?
//
// within(p, q, t) is true iff |p - q| <= t, decided exactly; t >= 0.
// Laws. (1) symmetric in p and q. (2) within(p, p, t). (3) within(p, q, 0) iff p equals q. (4) true
// for every greater t, too. Not true: that it is transitive.
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// t^2 - |p - q|^2.
struct WithinDistance {
  Vec3 p, q;
  double t;
  /// Differences 1, squares 4, their sums 5 and 6, the difference 7.
  static constexpr int depth = 7;
  template <class T>
  T value() const {
    const Vector3<T> d = lift<T>(p) - lift<T>(q);
    return T(t) * T(t) - dot(d, d);
  }
};

bool within(const Vec3& p, const Vec3& q, double t);

}  // namespace crest::kernel
