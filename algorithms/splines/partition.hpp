// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The type-6 tetrahedral partition (paper 001, section 7.2): every cube cut by the six planes
// through opposite edges into 24 tetrahedra [C, A, B, D]: the cube's centre C, the centre D of a
// face, corners A, B of an edge of that face.
//
// Lattice: a cube has side 2, so that corners are even, face centres mixed and centres odd. All
// planes of the partition are x, y, z, x +- y, x +- z, y +- z = an even integer. A coefficient of
// degree q is known by the sum of its word's letters, the lattice points; tetrahedra share it iff
// these sums are equal.
#include <array>
#include <cstdint>

#include "kernel/polynomial/simplex_net.hpp"

namespace crest::splines {

/// A point of the lattice, or a sum of some.
using Lattice = std::array<int, 3>;
constexpr Lattice operator+(const Lattice& a, const Lattice& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// The letters, in the order of a tetrahedron's corners.
enum Letter : std::size_t { kC, kA, kB, kD };

/// Tetrahedron 4 (2 a + s_a) + 2 m + s_m of a cube: the points whose coordinate a is largest, with
/// sign s_a (1: +), and the first (m = 0) or the second of the other two axes next, with sign s_m.
struct Tetrahedron {
  std::size_t face_axis, edge_axis, free_axis;  ///< a, the next, f along [A, B]
  int face_sign, edge_sign;
  std::array<Lattice, 4> corners;  ///< C A B D, from the cube's centre
};

inline constexpr std::size_t kTetrahedra = 24;

constexpr std::array<Tetrahedron, kTetrahedra> make_tetrahedra() {
  std::array<Tetrahedron, kTetrahedra> all{};
  for (std::size_t t = 0; t < kTetrahedra; ++t) {
    Tetrahedron& r = all[t];
    r.face_axis = t / 8;
    const std::size_t low = r.face_axis == 0 ? 1 : 0, high = 3 - r.face_axis - low;
    r.edge_axis = t / 2 % 2 == 0 ? low : high;
    r.free_axis = low + high - r.edge_axis;
    r.face_sign = t / 4 % 2 == 0 ? -1 : 1;
    r.edge_sign = t % 2 == 0 ? -1 : 1;
    Lattice d{};
    d[r.face_axis] = r.face_sign;
    Lattice a = d, b = d;
    a[r.edge_axis] = b[r.edge_axis] = r.edge_sign;
    a[r.free_axis] = -1;
    b[r.free_axis] = 1;
    r.corners = {Lattice{}, a, b, d};
  }
  return all;
}
inline constexpr std::array<Tetrahedron, kTetrahedra> kTetrahedron = make_tetrahedra();

/// The six signs of (7.11) as bits: x + y, x - y, x + z, x - z, y + z, y - z not negative.
template <class T>
constexpr unsigned sign_bits(const T& x, const T& y, const T& z) {
  return unsigned{!(x + y < 0)} | unsigned{!(x < y)} << 1 | unsigned{!(x + z < 0)} << 2 |
         unsigned{!(x < z)} << 3 | unsigned{!(y + z < 0)} << 4 | unsigned{!(y < z)} << 5;
}

constexpr std::array<std::uint8_t, 64> make_sign_table() {
  std::array<std::uint8_t, 64> table{};
  table.fill(kTetrahedra);
  for (std::size_t t = 0; t < kTetrahedra; ++t) {
    // Four times the barycentre: inside.
    Lattice p{};
    for (const Lattice& corner : kTetrahedron[t].corners) p = p + corner;
    table[sign_bits(p[0], p[1], p[2])] = static_cast<std::uint8_t>(t);
  }
  return table;
}
inline constexpr std::array<std::uint8_t, 64> kTetrahedronOfSigns = make_sign_table();

/// The tetrahedron that holds the point x, y, z from its cube's centre, zeros counted as +: that of
/// the point moved by (e, e^2, e^3). Requires: sums of T keep their signs, as rounded ones do.
template <class T>
constexpr std::size_t locate(const T& x, const T& y, const T& z) {
  return kTetrahedronOfSigns[sign_bits(x, y, z)];
}

/// Barycentric coordinates l_C, l_A, l_B, l_D of a point from its cube's centre.
template <class T>
constexpr std::array<T, 4> barycentric(std::size_t t, const std::array<T, 3>& p) {
  const Tetrahedron& s = kTetrahedron[t];
  const T face = s.face_sign < 0 ? T(-p[s.face_axis]) : p[s.face_axis];
  const T edge = s.edge_sign < 0 ? T(-p[s.edge_axis]) : p[s.edge_axis];
  const T& free = p[s.free_axis];
  const T half(0.5);
  return {T(1) - face, half * (edge - free), half * (edge + free), face - edge};
}

/// The gradient in lattice coordinates from the derivatives by the barycentric coordinates.
template <class T>
constexpr std::array<T, 3> gradient(std::size_t t, const std::array<T, 4>& by_corner) {
  const Tetrahedron& s = kTetrahedron[t];
  const T half(0.5);
  const T face = by_corner[kD] - by_corner[kC];
  const T edge = half * (by_corner[kA] + by_corner[kB]) - by_corner[kD];
  std::array<T, 3> g;
  g[s.face_axis] = s.face_sign < 0 ? T(-face) : face;
  g[s.edge_axis] = s.edge_sign < 0 ? T(-edge) : edge;
  g[s.free_axis] = half * (by_corner[kB] - by_corner[kA]);
  return g;
}

/// Where tetrahedron t keeps its coefficients of degree q: the sums of letters, from the sum of q
/// centres.
template <int Degree>
constexpr auto make_domain_points() {
  using Basis = kernel::SimplexBasis<3, Degree>;
  std::array<std::array<Lattice, Basis::count>, kTetrahedra> points{};
  for (std::size_t t = 0; t < kTetrahedra; ++t)
    for (std::size_t i = 0; i < Basis::count; ++i)
      for (std::size_t letter = 0; letter < 4; ++letter)
        for (int k = 0; k < Basis::indices[i][letter]; ++k)
          points[t][i] = points[t][i] + kTetrahedron[t].corners[letter];
  return points;
}
template <int Degree>
inline constexpr auto kDomainPoints = make_domain_points<Degree>();

/// Across a triangle, u and v the corners opposite: for every word w of q - 1 letters over the
/// triangle, a(wu) + a(wv) is 2 a(wD) (inter-cube and intra-pyramid, that is univariate) or
/// a(wC) + (a(wA) + a(wB)) / 2 (inter-pyramid, where u, v are face centres) iff the pieces meet C1.
enum class Junction : std::uint8_t { inter_cube, intra_pyramid, inter_pyramid };

/// A triangle between two tetrahedra, in the lattice, from the lower cube's centre.
struct Crossing {
  Junction junction;
  std::array<Lattice, 3> triangle;     ///< its letters' points, C or D last where there is one
  std::array<std::size_t, 3> letters;  ///< what they are
  std::array<Lattice, 2> opposite;     ///< u, v
};

/// The triangles of a cube: 36 within it, and towards the next cube along each axis, 4 each.
inline constexpr std::size_t kCrossings = 48;

constexpr std::array<Crossing, kCrossings> make_crossings() {
  std::array<Crossing, kCrossings> all{};
  std::size_t count = 0;
  for (std::size_t s = 0; s < kTetrahedra; ++s) {
    const auto& p = kTetrahedron[s].corners;
    if (kTetrahedron[s].face_sign > 0) {
      // The centre's image in the face.
      const Lattice u{}, v = p[kD] + p[kD];
      all[count++] = {Junction::inter_cube, {p[kA], p[kB], p[kD]}, {kA, kB, kD}, {u, v}};
    }
    for (std::size_t t = s + 1; t < kTetrahedra; ++t) {
      const auto& q = kTetrahedron[t].corners;
      const bool same_face = p[kD] == q[kD];
      const bool same_edge = p[kA] == q[kA] && p[kB] == q[kB];
      if (same_edge)
        all[count++] = {
            Junction::inter_pyramid, {p[kA], p[kB], p[kC]}, {kA, kB, kC}, {p[kD], q[kD]}};
      if (!same_face) continue;
      for (const std::size_t i : {kA, kB})
        for (const std::size_t k : {kA, kB})
          if (p[i] == q[k])
            all[count++] = {Junction::intra_pyramid,
                            {p[i], p[kD], p[kC]},
                            {kA, kD, kC},
                            {p[kA + kB - i], q[kA + kB - k]}};
    }
  }
  return all;
}
inline constexpr std::array<Crossing, kCrossings> kCrossing = make_crossings();

}  // namespace crest::splines
