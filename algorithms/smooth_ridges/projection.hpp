// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points of an implicit surface in double precision. Nothing is proven here: charts decide.
#include <optional>

#include "algorithms/smooth_ridges/surface.hpp"
#include "algorithms/smooth_ridges/triangulation.hpp"

namespace crest::smooth_ridges {

/// Not for two threads at a time.
class Projection {
 public:
  explicit Projection(const Surface& surface) : value_(surface), f_(surface) {}

  struct Sample {
    double value;
    Vec3 gradient;
  };
  Sample sample(const Vec3& p);
  double value(const Vec3& p) { return value_(p)[0]; }

  /// A zero of F near p by Newton's method along grad F, to rounding; nothing if it does not
  /// converge in steps that together stay within `reach`.
  std::optional<Vec3> onto(Vec3 p, double reach);
  /// The same along the direction m (unit length is not needed; reach is measured in space).
  std::optional<Vec3> along(Vec3 p, const Vec3& m, double reach);

  /// x, and N = grad F / |grad F| there.
  Vertex vertex(const Vec3& x);

 private:
  template <class Direction>
  std::optional<Vec3> newton(Vec3 p, double reach, Direction&& direction);

  ImplicitMap<double, 0> value_;
  ImplicitMap<double, 1> f_;
};

/// How triangulations of the surface are refined. Implicit: new points by projection of an edge's
/// midpoint along its mean normal. Parametric: lengths in the metric of X at the midpoint.
EdgeRules edge_rules(const Surface& surface);

inline Vec3 position(const Vertex& v) {
  return {v[0], v[1], v[2]};
}
inline Vec3 normal(const Vertex& v) {
  return {v[3], v[4], v[5]};
}

}  // namespace crest::smooth_ridges
