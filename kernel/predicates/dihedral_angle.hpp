// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Dihedral angle: is that between the normals of an edge's two faces above a given one?
//
// dihedral_angle(e, A) is positive if the angle is larger than A, negative if it is smaller, zero
// if it is exactly A. The angle is that between the faces' normals, 0 to 180 degrees: 0 in a plane,
// 180 where the faces lie on each other; convex and concave edges are alike. With
// s = n1 . n2 and q = n . n the cosine is s / sqrt(q1 q2): its sign is that of s, and where it
// agrees with cos A the sign of cos^2 A q1 q2 - s^2 decides.
//
// cos^2 A = (1 + cos 2A) / 2 is rational only for A = 0, 30, 45, 60, 90, 120, 135, 150 and 180
// degrees (Niven: of all rational degrees only those whose cosine is 0, +-1/2, +-1 have a rational
// one), where it is 0, 1/4, 1/2, 3/4 or 1: a double. For any other decimal A it is irrational, the
// ratio s^2 / (q1 q2) of doubles is not: no tie, and an enclosure of cos^2 A that narrows decides.
//
// Laws. (1) symmetric: exchanging the faces, with the edge's direction, changes nothing.
// (2) invariant under translation, permutation and reversal of axes, scaling by a power of two, as
// far as these are exact. (3) falls with A: not positive for A implies negative for larger angles.
// (4) zero only for the nine angles above. (5) for A = 0 zero iff the faces are coplanar and on
// either side of the edge; for A = 180 never positive.
#include <string>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// An angle given as a decimal of degrees, with what the ladder needs of its cosine.
class DecimalAngle {
 public:
  /// text: digits, with or without a point and more digits; at most 100 characters.
  /// Throws: std::invalid_argument, in words that follow the text, for another text or more than
  ///   180.
  explicit DecimalAngle(std::string text);

  const std::string& text() const { return text_; }
  /// The nearest double.
  double degrees() const { return degrees_; }
  Sign cosine() const { return cosine_; }
  /// Doubles around the squared cosine; equal iff it is rational.
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  std::string text_;
  double degrees_ = 0, low_ = 0, high_ = 0;
  Sign cosine_ = Sign::zero;
};

/// a - b of two inputs. In doubles it is the exact difference with one rounding, however much
/// cancels: its magnitude is its own, not that of a and b.
template <class T>
T input_difference(double a, double b) {
  return T(a) - T(b);
}
template <>
inline Approximate input_difference<Approximate>(double a, double b) {
  return Approximate(a - b);
}

/// The edge from v to w; left and right are the third corners of the faces (v, w, left) and
/// (w, v, right).
struct DihedralEdge {
  Vec3 v, w, left, right;

  template <class T>
  Vector3<T> from_v(const Vec3& p) const {
    return {input_difference<T>(p[0], v[0]), input_difference<T>(p[1], v[1]),
            input_difference<T>(p[2], v[2])};
  }
  template <class T>
  Vector3<T> left_normal() const {
    return cross(from_v<T>(w), from_v<T>(left));
  }
  template <class T>
  Vector3<T> right_normal() const {
    return cross(from_v<T>(right), from_v<T>(w));
  }
};

/// s, the sign of the angle's cosine.
struct NormalProduct {
  DihedralEdge e;
  /// Difference 1, minor 1 + 1 + 2 and 1, product 5 + 5 + 2, two sums.
  static constexpr int depth = 14;
  template <class T>
  T value() const {
    return dot(e.left_normal<T>(), e.right_normal<T>());
  }
};

/// c q1 q2 - s^2 for a double c: the sign of c - cos^2 of the edge's angle.
struct SquaredCosineGap {
  DihedralEdge e;
  double c;
  /// Products of two of depth 14: 30; with c 32; the difference.
  static constexpr int depth = 33;
  template <class T>
  T value() const {
    const Vector3<T> left = e.left_normal<T>(), right = e.right_normal<T>();
    const T s = dot(left, right);
    return T(c) * (dot(left, left) * dot(right, right)) - s * s;
  }
};

/// Nothing unless both faces of `e` have an area. triage and interval know cos^2 A by its doubles
/// alone.
MaybeSign triage_dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle);
MaybeSign interval_dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle);
Sign exact_dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle);

/// Requires: neither face's area is exactly zero.
/// Cost: 0.1 microseconds where doubles decide, some 50 in rationals.
Decision dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle);

}  // namespace crest::kernel
