// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The field of a certificate and the signs that everything else asks for.
#include <span>

#include "certify/exact/sign_ladder.hpp"
#include "certify/skeleton/records.hpp"
#include "certify/surface/corners.hpp"

namespace crest::certify::skeleton {

using u8 = std::uint8_t;
using u32 = std::uint32_t;
using kernel::Rational;
using kernel::Sign;
using Pair = std::array<double, 2>;

/// Two coordinates over any number type (certify/exact/vector.hpp).
template <class T>
struct Plane {
  T x, y;
};
template <class T>
Plane(T, T) -> Plane<T>;

template <class A, class B>
auto operator+(const Plane<A>& a, const Plane<B>& b) {
  return Plane{a.x + b.x, a.y + b.y};
}
template <class A, class B>
auto operator-(const Plane<A>& a, const Plane<B>& b) {
  return Plane{a.x - b.x, a.y - b.y};
}
template <class A, class B>
auto operator*(const A& c, const Plane<B>& b) {
  return Plane{c * b.x, c * b.y};
}
template <class A, class B>
auto det(const Plane<A>& a, const Plane<B>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class A, class B>
auto dot(const Plane<A>& a, const Plane<B>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class Lift>
auto lifted(const Lift& lift, const Pair& p) {
  return Plane{lift(p[0]), lift(p[1])};
}
inline Plane<Rational> exact(const Pair& p) {
  return {Rational(p[0]), Rational(p[1])};
}

inline bool is_zero(const Pair& v) {
  return v[0] == 0 && v[1] == 0;
}

/// The data by corner.
class Field {
 public:
  explicit Field(const SkeletonCertificate& c) : c_(c) {}

  std::size_t triangles() const { return c_.triangles.size(); }
  std::size_t corners() const { return 3 * c_.triangles.size(); }
  u32 vertex(u32 corner) const { return c_.triangles[corner / 3][corner % 3]; }
  const Pair& position(u32 corner) const { return c_.positions[vertex(corner)]; }
  const Pair& vector(u32 corner) const { return c_.vectors[vertex(corner)]; }
  Faces faces() const { return c_.triangles; }
  std::size_t vertices() const { return c_.positions.size(); }

 private:
  const SkeletonCertificate& c_;
};

/// Of det(v_a, v_b).
inline Sign turn_sign(SignLadder& sign, const Pair& a, const Pair& b) {
  return sign([&](const auto& lift) { return det(lifted(lift, a), lifted(lift, b)); });
}
inline Sign dot_sign(SignLadder& sign, const Pair& a, const Pair& b) {
  return sign([&](const auto& lift) { return dot(lifted(lift, a), lifted(lift, b)); });
}
/// Of det(q - p, r - p).
inline Sign orientation(SignLadder& sign, const Pair& p, const Pair& q, const Pair& r) {
  return sign([&](const auto& lift) {
    const auto base = lifted(lift, p);
    return det(lifted(lift, q) - base, lifted(lift, r) - base);
  });
}
/// Of det(q - p, v): positive is into what lies at the left of p -> q.
inline Sign inflow_sign(SignLadder& sign, const Pair& p, const Pair& q, const Pair& v) {
  return sign(
      [&](const auto& lift) { return det(lifted(lift, q) - lifted(lift, p), lifted(lift, v)); });
}
/// Of (q - p) . v.
inline Sign along_sign(SignLadder& sign, const Pair& p, const Pair& q, const Pair& v) {
  return sign(
      [&](const auto& lift) { return dot(lifted(lift, q) - lifted(lift, p), lifted(lift, v)); });
}

/// How often the segment from a to b, which does not meet the origin, crosses the positive x-axis
/// upwards; a point on it counts as above.
inline int axis_crossings(SignLadder& sign, const Pair& a, const Pair& b) {
  const bool low_a = a[1] < 0, low_b = b[1] < 0;
  if (low_a == low_b) return 0;
  const Sign turn = turn_sign(sign, a, b);
  return low_a ? turn == Sign::positive : -(turn == Sign::negative);
}

}  // namespace crest::certify::skeleton
