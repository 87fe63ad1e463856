// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What an eye sees of triangles (paper 001, section 3.5, made exact): side of an edge, crossing, in
// front, piercing, order of events, edge seen end-on, in front of the eye.
//
// All are signs of 4 x 4 determinants [p, q, r, s] of homogeneous points; the vertices have weight
// 1, the eye weight 1 or, infinitely far in a direction, 0. No projected point is ever made. Zeros
// are resolved by Simulation of Simplicity (Edelsbrunner and Muecke): coordinate j of the point of
// rank i moves by eps^(2^(3 i + j)), the eye has rank 0, vertex v rank v + 1. A coefficient of a
// monomial is the determinant with the rows that move replaced by unit vectors.
//
// Laws, for distinct vertices. (1) side and volume are never zero, odd under exchange of two
// vertices, and keep their sign when all are renumbered in the same order. (2) Where flat_side or
// flat_volume is not zero it is the answer. (3) crosses(a, b, c, d) is symmetric in a and b, in c
// and d, and in the two pairs; of crossing edges exactly one is in front. (4) A segment from the
// eye to a vertex meets a triangle it has no corner of, or passes it by: pierced or not, there is
// no third answer. (5) event_order is a total preorder of places on an edge: odd, transitive, ties
// are equal limits. (6) Turning the edge round reverses the order. Not true: that the answer to a
// tie is independent of the vertices' numbers.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/dihedral_angle.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

using VertexNumber = std::uint32_t;
inline constexpr VertexNumber kNoVertex = 0xffffffffU;
using Corners = std::array<VertexNumber, 3>;  ///< of a triangle

/// Where one looks from: a point, or the direction towards an eye infinitely far.
struct Eye {
  Vec3 at{};
  bool finite = false;
  double weight() const { return finite ? 1 : 0; }
};

/// [(p, w), (q, 1), (r, 1), (s, 1)] = det(p - w q; r - q; s - q).
struct SightOrientation {
  Vec3 p;
  double weight;  ///< 0 or 1
  Vec3 q, r, s;
  /// Differences 1, minors 1 + 1 + 2 and 1, products 5 + 1 + 2, two sums.
  static constexpr int depth = 10;
  template <class T>
  T value() const {
    Vector3<T> u, v, w;
    for (std::size_t j = 0; j < 3; ++j) {
      u[j] = weight == 0 ? T(p[j]) : input_difference<T>(p[j], q[j]);
      v[j] = input_difference<T>(r[j], q[j]);
      w[j] = input_difference<T>(s[j], q[j]);
    }
    return determinant(v, w, u);
  }
};

/// A determinant of four rows as they are: the coefficients of the perturbation.
struct HomogeneousRows {
  std::array<std::array<double, 4>, 4> row;
  /// Minors 3, products 3 + 3 + 2, five sums.
  static constexpr int depth = 13;
  template <class T>
  T value() const {
    const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
      return T(row[i][j]) * T(row[i + 1][k]) - T(row[i][k]) * T(row[i + 1][j]);
    };
    T sum = minor(0, 0, 1) * minor(2, 2, 3);
    sum = sum - minor(0, 0, 2) * minor(2, 1, 3);
    sum = sum + minor(0, 0, 3) * minor(2, 1, 2);
    sum = sum + minor(0, 1, 2) * minor(2, 0, 3);
    sum = sum - minor(0, 1, 3) * minor(2, 0, 2);
    return sum + minor(0, 2, 3) * minor(2, 0, 1);
  }
};

/// A2 B1 - A1 B2 of two planes with values A, B at an edge's ends.
struct PlaceGap {
  SightOrientation a1, b1, a2, b2;
  /// Products of two determinants, the difference.
  static constexpr int depth = 23;
  template <class T>
  T value() const {
    return a2.value<T>() * b1.value<T>() - a1.value<T>() * b2.value<T>();
  }
};

/// dot(z, p - w e): is p in front of an eye that looks along z.
struct InFrontOfEye {
  Vec3 z, p, e;
  /// Difference 1, product 1 + 2, two sums.
  static constexpr int depth = 5;
  template <class T>
  T value() const {
    return dot(lift<T>(z),
               Vector3<T>{input_difference<T>(p[0], e[0]), input_difference<T>(p[1], e[1]),
                          input_difference<T>(p[2], e[2])});
  }
};

/// Who decided, by rule.
struct SightCounts {
  StageCounts side, volume, order;
  SightCounts& operator+=(const SightCounts& o) {
    side += o.side;
    volume += o.volume;
    order += o.order;
    return *this;
  }
};

/// The plane of an event on an edge: of the eye and an edge (r = kNoVertex), or of a triangle.
struct EventPlane {
  VertexNumber p, q, r = kNoVertex;
};

/// Where an edge a -> b meets a plane whose sides a and b are on: t = A / (A - B), in the limit.
/// If both values vanish, A and B are the coefficients of the largest monomial at which one has
/// any, all monomials being those of the whole scene's ranks.
class EventPlace {
 public:
  /// Guess of t in double, for drawing and for first comparisons; never a decision.
  double guess() const { return guess_; }
  bool at_start() const { return start_; }  ///< the limit is 0
  bool at_end() const { return end_; }      ///< the limit is 1

 private:
  friend class Sight;
  EventPlane plane_{};
  bool positive_ = true;  ///< the sign of A
  bool start_ = false, end_ = false, symbolic_ = false;
  Approximate a_, b_;  ///< A and B, unless symbolic
  double guess_ = 0;
};

/// The decisions about a scene. Refers to the points, which are finite and distinct.
class Sight {
 public:
  Sight(const Eye& eye, const std::vector<Vec3>& points) : eye_(eye), points_(points) {}
  const Eye& eye() const { return eye_; }
  const Vec3& point(VertexNumber v) const { return points_[v]; }

  /// [e, a, b, c], the side of edge ab on which the eye sees c. Guarantees: not zero.
  Decision side(VertexNumber a, VertexNumber b, VertexNumber c, SightCounts& counts) const;
  /// [a, b, c, d]. Guarantees: not zero.
  Decision volume(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d,
                  SightCounts& counts) const;
  /// The same of the points as they are.
  Sign flat_side(VertexNumber a, VertexNumber b, VertexNumber c) const;
  Sign flat_volume(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d) const;

  /// Do the edges ab and cd, without a common vertex, cross in the picture.
  bool crosses(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d,
               SightCounts& counts) const;
  /// Is cd in front of ab. Requires: they cross.
  bool in_front(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d,
                SightCounts& counts) const;
  /// Does the segment ab go through the triangle. Requires: no common vertex.
  bool pierces(VertexNumber a, VertexNumber b, const Corners& f, SightCounts& counts) const;
  /// Is the triangle between the eye and a. Requires: a is no corner.
  bool covers(const Corners& f, VertexNumber a, SightCounts& counts) const;
  /// Do eye, a and b lie on one line.
  bool end_on(VertexNumber a, VertexNumber b) const;

  /// Requires: a and b on different sides of the plane, none of them a vertex of it.
  EventPlace place(VertexNumber a, VertexNumber b, const EventPlane& plane,
                   SightCounts& counts) const;
  /// The sign of t1 - t2, of limits: zero is an answer.
  Sign event_order(VertexNumber a, VertexNumber b, const EventPlace& first,
                   const EventPlace& second, SightCounts& counts) const;

 private:
  struct Coefficients;
  Coefficients coefficients(VertexNumber a, VertexNumber b, const EventPlane& plane) const;
  SightOrientation value_at(const EventPlane& plane, VertexNumber v) const;
  std::array<double, 4> row(VertexNumber rank) const;
  template <std::size_t N>
  Decision resolve(std::array<VertexNumber, N> ranks, SightOrientation formula,
                   StageCounts& counts) const;

  Eye eye_;
  const std::vector<Vec3>& points_;
};

/// Is p strictly in front of an eye at e that looks along z (negative: behind).
Sign in_front_of_eye(const Vec3& e, const Vec3& z, const Vec3& p);

}  // namespace crest::kernel
