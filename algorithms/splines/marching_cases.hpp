// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Marching tetrahedra: the triangles between the corners below a level and the others.
#include <array>
#include <cstdint>

namespace crest::splines {

/// The edges of a tetrahedron in their order.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kTetrahedronEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

struct MarchingCase {
  std::uint8_t count = 0;
  std::array<std::array<std::uint8_t, 3>, 2> triangles{};  ///< edges, on each a vertex
  /// Whether the normals, (b - a) x (c - a), point to where it is below the level, if (x1 - x0) x
  /// (x2 - x0) . (x3 - x0) > 0 for the corners x; else the other way.
  bool towards_below = false;
};

/// By the corners below: bit i for corner i.
constexpr std::array<MarchingCase, 16> make_marching_cases() {
  std::array<MarchingCase, 16> cases{};
  const auto edge = [](std::size_t i, std::size_t k) {
    std::uint8_t e = 0;
    while (kTetrahedronEdges[e][0] != (i < k ? i : k) || kTetrahedronEdges[e][1] != (i < k ? k : i))
      ++e;
    return e;
  };
  for (std::size_t below = 1; below < 15; ++below) {
    std::array<std::size_t, 4> n{}, p{};  // below, not below
    std::size_t nn = 0, np = 0;
    for (std::size_t i = 0; i < 4; ++i) (below >> i & 1 ? n[nn++] : p[np++]) = i;
    MarchingCase& c = cases[below];
    if (nn == 2) {
      c.count = 2;
      c.triangles = {{{edge(p[0], n[0]), edge(p[0], n[1]), edge(p[1], n[1])},
                      {edge(p[0], n[0]), edge(p[1], n[1]), edge(p[1], n[0])}}};
      // Normals are along (n1 - n0) x (p1 - p0): towards n iff n0 n1 p0 p1 is an even order, as are
      // of these 01 23, 03 12, 12 03 and 23 01.
      c.towards_below = n[0] + n[1] != 2 && n[0] + n[1] != 4;
    } else {
      // One corner v on its side: seen from there the others are clockwise, as they come, iff v is
      // 0 or 2.
      const bool alone_below = nn == 1;
      const auto& others = alone_below ? p : n;
      const std::size_t v = alone_below ? n[0] : p[0];
      c.count = 1;
      c.triangles[0] = {edge(v, others[0]), edge(v, others[1]), edge(v, others[2])};
      c.towards_below = (v % 2 == 1) == alone_below;
    }
  }
  return cases;
}
inline constexpr std::array<MarchingCase, 16> kMarchingCases = make_marching_cases();

}  // namespace crest::splines
