// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate points of a face, from its three tensors alone: at most four. They are the common
// points of two conics (degenerate_conic.hpp) at which the three coordinate forms have one sign: >
// 0 linear, < 0 planar.
//
// Stages. cone: a bound shows that there are none. triage: doubles with error radii; the number of
// real common points is 4 or 2 by the sign of the quartic's discriminant (two traceless conics
// always meet: some combination of two real conics without a real common point is definite, and its
// trace is zero), so as many sign changes in disjoint intervals are all of them. exact: rationals
// and real_roots.
#include <array>
#include <optional>
#include <span>

#include "algorithms/modes/degenerate_conic.hpp"

namespace crest::modes {

/// A deviator's direction in an orthonormal basis of traceless tensors; not usable: zero, or so
/// small beside the tensor's trace that doubles do not bound it.
struct Direction {
  std::array<double, 5> x{};
  bool usable = false;
  double error = 0;  ///< bounds the distance from the exact direction
};
Direction direction(const Tensor& t);

/// True proves: no positive combination of the directions is degenerate or zero.
/// Theorem. If <u_i, U> >= c |U| > 0 for unit u_i, all positive combinations lie within arccos c of
/// U; the degenerate tensor nearest to U is arccos(|mode U|) / 3 away; so 4 c^3 - 3 c > |mode U|
/// is enough. Doubles, u = 2^-53: with tensors of entries at most L the coordinates of direction()
/// are off by 11 u L in norm, and projection to the sphere shrinks what is outside of it, so its x
/// is off by 64 u L / |d| at most, a middle's by the sum of its ends' and 16 u over its length. U
/// is whatever was computed; c loses the largest error, and 4 c^3 - 3 c at most 9 times that; the
/// roundings of c and of the mode of U together stay below 2000 u.
bool cone_excludes(std::span<const Direction> u);
/// The same after at most 2^depth bisections, each halving the largest angle.
bool cones_exclude(std::span<const Direction> u, int depth);

struct FaceRoot {
  DegenerateType type;
  kernel::Vector3<Ball> v;
  std::array<Ball, 3> weights;  ///< barycentric
};

enum class FaceStage : std::uint8_t { cone, triage, exact };

struct FaceRoots {
  std::array<FaceRoot, 4> root;
  std::size_t count = 0;
  FaceStage stage = FaceStage::exact;
  std::optional<SpecialReason> special;
  /// The two conics have a multiple common point (or all in common), maybe a complex one or one
  /// outside the face.
  bool multiple = false;
};

/// Requires: finite tensors, in the order of the corners' numbers: both tets of a face see the
/// same.
FaceRoots face_roots(const std::array<const Tensor*, 3>& corners);
/// Nothing: not decided.
std::optional<FaceRoots> triage_face_roots(const std::array<const Tensor*, 3>& corners);
FaceRoots exact_face_roots(const std::array<const Tensor*, 3>& corners);

}  // namespace crest::modes
