// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Quadratic functions on edges and faces by their nodal values: the formulas of SPEC.md, over any
// number type.
#include "certify/reeb/checks.hpp"

namespace crest::certify::reeb {

/// At the vertex of smaller index, at the other, in the middle.
struct EdgeValues {
  double a, b, m;
};
inline EdgeValues values_on_edge(const ReebContents& c, const Gluing& mesh, std::uint32_t e) {
  return {c.values[mesh.edges[e][0]], c.values[mesh.edges[e][1]], c.edge_values[e]};
}

/// d_a and d_b: the derivatives along the edge at its ends.
template <class Lift>
auto start_slope(const Lift& lift, const EdgeValues& e) {
  return lift(4) * lift(e.m) - lift(3) * lift(e.a) - lift(e.b);
}
template <class Lift>
auto end_slope(const Lift& lift, const EdgeValues& e) {
  return lift(3) * lift(e.b) + lift(e.a) - lift(4) * lift(e.m);
}

/// f at the corners, m at the middle of the side from corner i to the next.
struct FaceValues {
  std::array<double, 3> f, m;
};
inline FaceValues values_in_face(const ReebContents& c, const Gluing& mesh, std::uint32_t face) {
  FaceValues v;
  for (std::size_t i = 0; i < 3; ++i) {
    v.f[i] = c.values[c.faces[face][i]];
    v.m[i] = c.edge_values[mesh.edge_of[3 * face + i]];
  }
  return v;
}

/// f0 + g s + h t + (P s^2 + 2 Q s t + R t^2) / 2 with s along c0 c1, t along c0 c2.
template <class T, class U>
struct Quadratic {
  T g, h, P, R;
  U Q;
  auto hessian() const { return P * R - Q * Q; }
  /// The critical point's barycentric coordinates for c1 and c2, times the hessian.
  auto weight1() const { return h * Q - g * R; }
  auto weight2() const { return g * Q - h * P; }
  auto weight0() const { return hessian() - weight1() - weight2(); }
};
template <class T, class U>
Quadratic(T, T, T, T, U) -> Quadratic<T, U>;

template <class Lift>
auto quadratic(const Lift& lift, const FaceValues& v) {
  const auto f0 = lift(v.f[0]), f1 = lift(v.f[1]), f2 = lift(v.f[2]);
  const auto m0 = lift(v.m[0]), m1 = lift(v.m[1]), m2 = lift(v.m[2]);
  return Quadratic{lift(4) * m0 - lift(3) * f0 - f1, lift(4) * m2 - lift(3) * f0 - f2,
                   lift(4) * (f0 + f1 - lift(2) * m0), lift(4) * (f0 + f2 - lift(2) * m2),
                   lift(4) * (f0 + m1 - m0 - m2)};
}

inline kernel::Sign weight_sign(const FaceValues& v, unsigned corner, SignLadder& sign) {
  if (corner == 1) return sign([&](auto lift) { return quadratic(lift, v).weight1(); });
  if (corner == 2) return sign([&](auto lift) { return quadratic(lift, v).weight2(); });
  return sign([&](auto lift) { return quadratic(lift, v).weight0(); });
}

}  // namespace crest::certify::reeb
