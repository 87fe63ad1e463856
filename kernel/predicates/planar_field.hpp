// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Signs of a plane field that is linear on triangles (paper 001, chapter 5): turn of two vectors,
// class of a zero inside a triangle, flow across a boundary edge.
//
// vector_turn(a, b) is the sign of det(a, b). A zero lies strictly inside a triangle iff the turns
// of its vectors, taken around it, are equal and not zero: a saddle if negative. Laws. (1)
// vector_turn(b, a) = -vector_turn(a, b). (2) zero iff a and b are parallel or one is zero. (3)
// symbolic_vector_turn is never zero, odd under exchange of the two with their numbers, and the
// indices it gives sum to the winding of the field wherever that is defined. (4) trace and
// discriminant are independent of the order of the corners; the discriminant's sign is that of tr^2
// - 4 det. (5) flow_across(p, q, v) = -flow_across(q, p, v). Not true: that the perturbed index of
// a zero on the boundary is independent of the frame.
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

struct VectorTurn {
  Vec2 a, b;
  static constexpr int depth = 3;
  template <class T>
  T value() const {
    return T(a[0]) * T(b[1]) - T(a[1]) * T(b[0]);
  }
};

/// The climb of a tie or of products too small or large to compare.
Sign exact_vector_turn(const Vec2& a, const Vec2& b);

/// Rounding is monotone, so rounded products that differ are ordered as the exact ones are.
inline MaybeSign triage_vector_turn(const Vec2& a, const Vec2& b) {
  const double p = a[0] * b[1], q = a[1] * b[0];
  if (p > q) return Sign::positive;
  if (p < q) return Sign::negative;
  return std::nullopt;
}

inline Sign vector_turn(const Vec2& a, const Vec2& b) {
  if (const MaybeSign s = triage_vector_turn(a, b)) return *s;
  return exact_vector_turn(a, b);
}

/// The turn where zero is resolved by Simulation of Simplicity: vector i is displaced by powers of
/// an infinitesimal that fall with i. Requires: i != j. Guarantees: not zero.
Sign symbolic_vector_turn(std::uint32_t i, const Vec2& a, std::uint32_t j, const Vec2& b);

/// Corners and vectors of a triangle.
struct FieldOnTriangle {
  std::array<Vec2, 3> p, v;
};

/// Trace of the Jacobian times twice the area.
struct FieldTrace : FieldOnTriangle {
  static constexpr int depth = 6;
  template <class T>
  T value() const {
    const auto x = [&](int i, int k) {
      return T(p[static_cast<unsigned>(i)][static_cast<unsigned>(k)]);
    };
    const auto w = [&](int i, int k) {
      return T(v[static_cast<unsigned>(i)][static_cast<unsigned>(k)]);
    };
    T sum = w(0, 0) * (x(1, 1) - x(2, 1)) + w(0, 1) * (x(2, 0) - x(1, 0));
    sum = sum + (w(1, 0) * (x(2, 1) - x(0, 1)) + w(1, 1) * (x(0, 0) - x(2, 0)));
    return sum + (w(2, 0) * (x(0, 1) - x(1, 1)) + w(2, 1) * (x(1, 0) - x(0, 0)));
  }
};

/// (tr^2 - 4 det) of the Jacobian times the square of twice the area.
struct FieldDiscriminant : FieldOnTriangle {
  static constexpr int depth = 15;
  template <class T>
  T value() const {
    const auto det = [](const std::array<Vec2, 3>& q) {
      return (T(q[1][0]) - T(q[0][0])) * (T(q[2][1]) - T(q[0][1])) -
             (T(q[1][1]) - T(q[0][1])) * (T(q[2][0]) - T(q[0][0]));
    };
    const T trace = FieldTrace{{p, v}}.template value<T>();
    return trace * trace - T(4.0) * (det(v) * det(p));
  }
};

Sign trace_sign(const FieldOnTriangle& t);
Sign field_discriminant_sign(const FieldOnTriangle& t);

/// det(q - p, v): v's part along the left normal of p -> q.
struct FlowAcross {
  Vec2 p, q, v;
  static constexpr int depth = 4;
  template <class T>
  T value() const {
    return (T(q[0]) - T(p[0])) * T(v[1]) - (T(q[1]) - T(p[1])) * T(v[0]);
  }
};
/// dot(q - p, v).
struct FlowAlong {
  Vec2 p, q, v;
  static constexpr int depth = 4;
  template <class T>
  T value() const {
    return (T(q[0]) - T(p[0])) * T(v[0]) + (T(q[1]) - T(p[1])) * T(v[1]);
  }
};

Sign flow_across(const Vec2& p, const Vec2& q, const Vec2& v);
Sign flow_along(const Vec2& p, const Vec2& q, const Vec2& v);

/// Is p, q, r counter-clockwise; zero: on one line.
Sign orientation(const Vec2& p, const Vec2& q, const Vec2& r);

}  // namespace crest::kernel
