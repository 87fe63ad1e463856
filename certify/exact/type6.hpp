// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The type-6 tetrahedra of a cube (spline_rays/SPEC.md, "Partition"), in lattice coordinates: a
// cube's side is 2, the point is measured from its centre.
#include <array>
#include <cstddef>

namespace crest::certify {

/// The two axes other than one, ascending.
inline constexpr std::size_t kOtherAxes[3][2] = {{1, 2}, {0, 2}, {0, 1}};

inline constexpr unsigned kTetrahedra = 24;

/// [C, A, B, D]: C is the centre, D that of the face on the side `upper` of axis a, AB the edge of
/// that face along axis f on the side `outer` of axis m, from its lower end to its upper one.
struct Tetrahedron {
  std::size_t a, m, f;
  unsigned upper, outer;

  /// Bits of the corner at an end of AB: at the upper end along an axis.
  constexpr unsigned corner(unsigned end) const { return upper << a | outer << m | end << f; }
  /// C, A, B, D.
  constexpr std::array<std::array<int, 3>, 4> vertices() const {
    std::array<std::array<int, 3>, 4> v{};
    for (const std::size_t i : {1, 2, 3}) v[i][a] = upper != 0 ? 1 : -1;
    for (const std::size_t i : {1, 2}) v[i][m] = outer != 0 ? 1 : -1;
    v[1][f] = -1;
    v[2][f] = 1;
    return v;
  }
};

/// Requires: number < kTetrahedra.
inline constexpr Tetrahedron tetrahedron(unsigned number) {
  const std::size_t a = number / 8, which = number / 2 % 2;
  return {a, kOtherAxes[a][which], kOtherAxes[a][1 - which], number / 4 % 2, number % 2};
}

/// Barycentrics in the order C, A, B, D of the point d.
template <class Number>
std::array<Number, 4> barycentrics(const Tetrahedron& tet, const std::array<Number, 3>& d) {
  const Number along = tet.upper != 0 ? d[tet.a] : Number(-d[tet.a]);
  const Number across = tet.outer != 0 ? d[tet.m] : Number(-d[tet.m]);
  const Number half(0.5);
  return {Number(1) - along, half * (across - d[tet.f]), half * (across + d[tet.f]),
          along - across};
}

/// Number of the tetrahedron by the signs of x + y, x - y, x + z, x - z, y + z, y - z, a bit each:
/// 1 if not negative. Any number if no point has these signs.
inline unsigned tetrahedron_by_signs(unsigned signs) {
  // The sign of S e_i - T e_j.
  const auto not_negative = [signs](std::size_t i, int s, std::size_t j, int t) {
    if (i > j) {
      const std::size_t k = i;
      i = j;
      j = k;
      const int u = s;
      s = -t;
      t = -u;
    }
    const unsigned form = 2 * static_cast<unsigned>(i + j - 1) + (s == t ? 1U : 0U);
    return ((signs >> form & 1U) != 0) == (s > 0);
  };
  for (unsigned number = 0; number + 1 < kTetrahedra; ++number) {
    const Tetrahedron tet = tetrahedron(number);
    const int s = tet.upper != 0 ? 1 : -1, t = tet.outer != 0 ? 1 : -1;
    if (not_negative(tet.a, s, tet.m, t) && not_negative(tet.m, t, tet.f, 1) &&
        not_negative(tet.m, t, tet.f, -1))
      return number;
  }
  return kTetrahedra - 1;
}

}  // namespace crest::certify
