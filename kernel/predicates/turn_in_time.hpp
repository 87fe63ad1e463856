// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Opposite times: when two moving plane vectors are opposite (paper 001, section 5.5.2): a = (1 -
// t) a0 + t a1 and b alike, t from 0 to 1. A zero of a field that is linear on triangles crosses an
// edge then.
//
// With u = t / (1 - t), which grows with t from 0 to infinity, det(a, b) is a quadratic in u up to
// a positive factor, without cancellation in its coefficients: det(a0, b0) + (det(a0, b1) + det(a1,
// b0)) u + det(a1, b1) u^2. The vectors are opposite at its positive roots where dot(a, b) is
// negative.
//
// Laws. (1) The times are the same for b, a; for both vectors times a positive factor; for a, -b
// they are those of equal directions. (2) Exchanging the two ends in time takes t to 1 - t. (3)
// There are two at most. (4) event_order is antisymmetric, and zero iff the times are equal. `tied`
// says that a zero does not simply cross: a vector vanishes, both are opposite at time 0 or 1, only
// touch that, or stay opposite for a while.
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/quadratic_root.hpp"

namespace crest::kernel {

struct MovingPair {
  Vec2 a0, a1, b0, b1;
};

/// det(a, b) in u.
struct TurnInTime : MovingPair {
  static constexpr int depth = 4;
  template <class T>
  QuadraticOf<T> value() const {
    const auto det = [](const Vec2& p, const Vec2& q) {
      return T(p[0]) * T(q[1]) - T(p[1]) * T(q[0]);
    };
    return {det(a1, b1), det(a0, b1) + det(a1, b0), det(a0, b0)};
  }
};
/// dot(a, b) in u.
struct DotInTime : MovingPair {
  static constexpr int depth = 4;
  template <class T>
  QuadraticOf<T> value() const {
    const auto dot = [](const Vec2& p, const Vec2& q) {
      return T(p[0]) * T(q[0]) + T(p[1]) * T(q[1]);
    };
    return {dot(a1, b1), dot(a0, b1) + dot(a1, b0), dot(a0, b0)};
  }
};

struct OppositeTimes {
  int count = 0;  ///< 0 to 2
  std::array<QuadraticRoot, 2> roots{};
  std::array<double, 2> times{};  ///< nearly
  bool tied = false;
};

/// Requires: finite.
OppositeTimes opposite_times(const MovingPair& pair);

/// The sign of (time of the first pair's root) - (that of the second's). Requires: both are among
/// their opposite_times.
Sign event_order(const MovingPair& p, QuadraticRoot i, const MovingPair& q, QuadraticRoot k);

}  // namespace crest::kernel
