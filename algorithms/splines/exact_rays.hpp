// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The first zero on a part of a ray in rationals: all cuts in order, equal ones merged, rule
// segment_zero on every segment between neighbours.
#include <cmath>

#include "algorithms/splines/exact_frame.hpp"
#include "algorithms/splines/rays.hpp"

namespace crest::splines {

inline double next_up(double x) {
  return std::nextafter(x, HUGE_VAL);
}
inline double next_down(double x) {
  return std::nextafter(x, -HUGE_VAL);
}

/// A ray in the lattice.
struct ExactRay {
  ExactPoint origin, direction;
  ExactPoint at(const Rational& t) const;
};

class ExactRays {
 public:
  ExactRays(const QuadraticSpline& spline, double level);

  ExactRay lift(const Ray& ray) const;
  /// The part with t >= 0 in the closed domain; nothing if there is none.
  std::optional<std::array<Rational, 2>> clip(const ExactRay& ray) const;
  /// The first zero with `from` <= t <= `to`, a part of the clipped ray. Sets all of a hit but
  /// place and gradient; `counts` its cubes and tetrahedra.
  std::optional<Hit> first_zero(const ExactRay& ray, const Rational& from, const Rational& to,
                                RayCounts& counts) const;

 private:
  struct Piece;
  Piece piece_at(const ExactPoint& x) const;
  const QuadraticSpline& spline_;
  ExactFrame frame_;
  Rational level_;
};

}  // namespace crest::splines
