// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The first point of a ray on a level set {s = c} of a quadratic spline, touching included (paper
// 001, section 8.5), proven: doubles with one bound a ray decide almost all, rationals the rest.
#include <memory>
#include <optional>

#include "algorithms/splines/active_cubes.hpp"

namespace crest::splines {

/// The points origin + t direction, t >= 0, in the world.
struct Ray {
  Vec3 origin, direction;
};

/// What is wrong with a ray for the caster, and the remedy; else nothing.
const char* problem_of(const Ray& ray);

struct Hit {
  bool hit = false;
  bool tangent = false;  ///< the ray touches the level set: a double zero
  bool climbed = false;  ///< rationals decided
  std::uint8_t tetrahedron = 0;
  Cube cube{};
  double t = 0, t_lo = 0, t_hi = 0;  ///< the first zero is in [t_lo, t_hi], at most 4 ulp apart
  Vec3 place{}, gradient{};          ///< in the world, at t
};

struct RayCounts {
  std::uint64_t cast = 0, hits = 0, tangent = 0, climbed = 0, cubes = 0, tetrahedra = 0;
  RayCounts& operator+=(const RayCounts& o);
};

class ExactRays;

class RayCaster {
 public:
  /// Requires: c finite; `spline` outlives the caster. Cost: 12 ns a cube.
  RayCaster(const QuadraticSpline& spline, double c);
  ~RayCaster();

  double level() const { return level_; }
  const ActiveCubes& active() const { return active_; }

  /// Theorem. If hit, the first t >= 0 with the point in the closed domain and s = c is in
  /// [t_lo, t_hi] and its point in the closure of the named tetrahedron, which is that of the first
  /// segment between neighbouring cuts that has a zero; if not, there is none.
  /// Proof. r(t), computed, is within eta of the true point, and the walk's intervals of t, each
  /// with a tetrahedron, follow one another without a gap; on each the point is within 3 eta of the
  /// tetrahedron, as every plane that parts it from others is crossed where computed up to eta. So
  /// s and the piece differ by less than delta there, and what triage_segment_zero says with slack
  /// delta is true of s. Of a hit's root t: on [.., t - w] there is no zero likewise, and from t -
  /// w to t + w the point is inside the tetrahedron by more than eta, s is the piece, which changes
  /// sign once. Cubes without an active bit differ from c by more than delta. Where any of this
  /// fails, rationals decide the cube's interval: all cuts in order, rule segment_zero.
  /// Requires: finite numbers, a direction that is not 0, and parameters in the domain that doubles
  /// hold.
  Hit cast(const Ray& ray, RayCounts& counts) const;
  /// By threads; counts are the sums. `hits` has the rays' length.
  RayCounts cast(std::span<const Ray> rays, std::span<Hit> hits) const;

 private:
  struct Walk;
  const QuadraticSpline& spline_;
  double level_;
  ActiveCubes active_;
  std::unique_ptr<const ExactRays> exact_;
};

}  // namespace crest::splines
