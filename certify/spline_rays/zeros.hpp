// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Zeros of s - c on segments of a ray (SPEC.md, step 4).
#include "certify/spline_rays/lattice_ray.hpp"
#include "certify/spline_rays/records.hpp"
#include "certify/spline_rays/segment.hpp"

namespace crest::certify::spline_rays {

/// What all rays share.
struct Scene {
  explicit Scene(const SplineVolume& volume);

  const SplineVolume& volume;
  QuadraticSpline spline;
  std::vector<std::uint8_t> one_sided;  ///< a cube: it holds no zero
  LatticeFrame<kernel::Interval> near;
  LatticeFrame<kernel::Rational> exact;
  LatticeFrame<LongBall> fine;
  std::array<std::uint8_t, 64> tetrahedra;  ///< by signs
};

/// A tetrahedron of a cube, and the part of the ray in it.
struct Segment {
  CubePosition cube;
  unsigned tetrahedron;
  Parameter from, to;
};

/// Requires: rounding upward.
class Zeros {
 public:
  Zeros(const Scene& scene, const LatticeRay& ray) : scene_(scene), ray_(ray) {}

  /// Whether there is one between two parameters, these included.
  bool any_on(const Segment& segment, const Parameter& from, const Parameter& to);
  /// Why the segment, which holds the ray's first zero, is not that of a hit; null if it is.
  const char* objection(const Segment& segment, const SplineHit& hit);

 private:
  /// The same without `to`.
  bool any_before(const Segment& segment, const Parameter& from, const Parameter& to);
  template <class Question>
  bool ask(const Segment& segment, const Parameter& from, const Parameter& to,
           const Question& question);
  template <class Number>
  Along<Number> along(const Segment& segment, std::array<Number, 3> from, std::array<Number, 3> to);
  Quadratic<kernel::Interval> quadratic_on(const CubePosition& cube, const Tetrahedron& tet,
                                           const kernel::Interval&);
  /// LongBall, Rational. Of integer samples intervals of coefficients are points: then these are
  /// the exact ones.
  template <class Number>
  Quadratic<Number> quadratic_on(const CubePosition& cube, const Tetrahedron& tet, const Number&);

  const Scene& scene_;
  const LatticeRay& ray_;
  /// Kept for the next segment, which is often in the same cube.
  std::optional<CubeCoefficients<kernel::Interval>> near_;
  CubePosition near_cube_{};
};

}  // namespace crest::certify::spline_rays
