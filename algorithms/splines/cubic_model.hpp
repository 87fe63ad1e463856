// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cubic splines on the type-6 partition in normal form: 14 numbers a cube (README.md beside this
// file), in cube coordinates: cubes have side 1.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::splines {

using kernel::Index;
using kernel::Vec3;

/// Indices of a vertex, or of a cube, possibly outside of the domain.
using Place = std::array<int, 3>;

inline Vec3 point(const Place& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline Vec3 middle(const Place& cube) {
  return {cube[0] + 0.5, cube[1] + 0.5, cube[2] + 0.5};
}

/// As on a chessboard: a black cube has an even sum of indices.
constexpr bool is_black(const Place& cube) {
  return ((cube[0] + cube[1] + cube[2]) & 1) == 0;
}

/// A closed box cut into cubes.
struct Domain {
  Vec3 low{}, high{};  ///< finite, low < high
  std::array<Index, 3> cubes{1, 1, 1};

  bool contains(const Vec3& p) const {
    bool inside = true;
    for (std::size_t d = 0; d < 3; ++d) inside = inside && low[d] <= p[d] && p[d] <= high[d];
    return inside;
  }
  /// Of a point of the box.
  Vec3 cube_coordinates(const Vec3& p) const {
    Vec3 x;
    for (std::size_t d = 0; d < 3; ++d) {
      const double n = cubes[d];
      x[d] = std::min((p[d] - low[d]) / (high[d] - low[d]) * n, n);
    }
    return x;
  }
  /// The derivatives of the cube coordinates.
  Vec3 density() const {
    Vec3 s;
    for (std::size_t d = 0; d < 3; ++d) s[d] = cubes[d] / (high[d] - low[d]);
    return s;
  }
  /// Places of cubes and vertices in arrays, the first index fastest.
  std::size_t cube(std::size_t i, std::size_t j, std::size_t k) const {
    return i + cubes[0] * (j + cubes[1] * k);
  }
  std::size_t vertex(std::size_t i, std::size_t j, std::size_t k) const {
    return i + (cubes[0] + std::size_t{1}) * (j + (cubes[1] + std::size_t{1}) * k);
  }
  std::size_t cube(const Place& q) const {
    return cube(std::size_t(q[0]), std::size_t(q[1]), std::size_t(q[2]));
  }
  std::size_t vertex(const Place& v) const {
    return vertex(std::size_t(v[0]), std::size_t(v[1]), std::size_t(v[2]));
  }
  bool has_cube(const Place& q) const {
    bool inside = true;
    for (std::size_t d = 0; d < 3; ++d)
      inside = inside && q[d] >= 0 && q[d] < static_cast<int>(cubes[d]);
    return inside;
  }
  std::size_t cube_count() const { return std::size_t{cubes[0]} * cubes[1] * cubes[2]; }
  std::size_t vertex_count() const {
    return (cubes[0] + std::size_t{1}) * (cubes[1] + std::size_t{1}) * (cubes[2] + std::size_t{1});
  }
};

enum class Smoothness : std::uint8_t {
  c1,         ///< exactly C1, in integers
  local,      ///< C1 but for triangles inside cubes
  sequential  ///< as the thesis extends it
};

/// The axes across an axis, in order.
constexpr std::array<std::array<std::size_t, 2>, 3> kAcross{{{1, 2}, {0, 2}, {0, 1}}};

/// f_A, then g_A; f_C, then g_C. With a(w) the coefficient of the word w, for every vertex X of a
/// tetrahedron at A: a(AAX) = f_A + g_A.(X - A); likewise a(CCX).
using ValueAndSlope = std::array<double, 4>;

/// Of the edges A, A + e_a for a = x, y, z, two each, along the axes across: a(ABX) lies on the
/// line from a(AAB) to a(ABB), plus t.(X - A). Zero where there is no edge.
using EdgeSlopes = std::array<double, 6>;

/// Calls visit for the places of `size` indices along each axis, the first the fastest.
template <class Visit>
void for_each_place(const std::array<Index, 3>& size, const Visit& visit) {
  for (int k = 0; k < static_cast<int>(size[2]); ++k)
    for (int j = 0; j < static_cast<int>(size[1]); ++j)
      for (int i = 0; i < static_cast<int>(size[0]); ++i) visit(Place{i, j, k});
}

struct CubicModel {
  Domain domain;
  Smoothness smoothness = Smoothness::c1;
  double unit =
      0;  ///< u of a C1 model: f and t are multiples of u, g of 2 u, f_C of u/8, g_C of u/4
  std::vector<ValueAndSlope> vertices;  ///< vertex_count()
  std::vector<EdgeSlopes> slopes;       ///< of the edges that start at each vertex
  std::vector<ValueAndSlope> centres;   ///< cube_count()
};

}  // namespace crest::splines
