// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The equations of the normal form over any number type: integers in units of u, doubles,
// rationals. Signs s of corners and edges: -1 below the cube's centre, +1 above.
#include <array>
#include <cstddef>

#include "algorithms/splines/cubic_model.hpp"

namespace crest::splines {

/// The numbers of one cube. Corner c has coordinates c & 1, c >> 1 & 1, c >> 2; edge 4 a + b + 2 c
/// runs along the axis a at the places b, c of the axes across.
template <class T>
struct CubeNumbers {
  std::array<T, 8> f;
  std::array<std::array<T, 3>, 8> h;  ///< g / 2
  std::array<std::array<T, 2>, 12> t;
};

constexpr bool is_upper(std::size_t corner, std::size_t axis) {
  return (corner >> axis & 1) != 0;
}

/// The corner at the lower end of an edge.
constexpr std::size_t lower_corner(std::size_t edge) {
  const auto& across = kAcross[edge / 4];
  return (edge & 1) << across[0] | (edge >> 1 & 1) << across[1];
}

/// A corner of a cube.
constexpr Place corner_of(const Place& cube, std::size_t corner) {
  Place v = cube;
  for (std::size_t d = 0; d < 3; ++d) v[d] += is_upper(corner, d) ? 1 : 0;
  return v;
}

template <class T>
T with_sign(bool plus, const T& x) {
  return plus ? x : T(-x);
}

/// 4 a(ACC) as each corner's inter-pyramid conditions ask for it: the sum of 2 a(ABC) over its
/// three edges AB, less 2 a(AAC).
template <class T>
std::array<T, 8> fourfold_targets(const CubeNumbers<T>& q) {
  std::array<T, 8> targets;
  for (std::size_t c = 0; c < 8; ++c) {
    T aac = q.f[c];
    for (std::size_t d = 0; d < 3; ++d) aac -= with_sign(is_upper(c, d), q.h[c][d]);
    targets[c] = T(-2) * aac;
  }
  for (std::size_t e = 0; e < 12; ++e) {
    const std::size_t a = e / 4, low = lower_corner(e), high = low | std::size_t{1} << a;
    T abc = q.f[low] + q.f[high] + T(2) * (q.h[low][a] - q.h[high][a]);  // twice
    for (std::size_t i = 0; i < 2; ++i) abc -= with_sign(is_upper(low, kAcross[a][i]), q.t[e][i]);
    targets[low] += abc;
    targets[high] += abc;
  }
  return targets;
}

/// 32 f_C and 16 g_C that come nearest to these in the sense of least squares.
template <class T>
std::array<T, 4> centre_of_targets(const std::array<T, 8>& fourfold) {
  std::array<T, 4> centre{T(0), T(0), T(0), T(0)};
  for (std::size_t c = 0; c < 8; ++c) {
    centre[0] += fourfold[c];
    for (std::size_t d = 0; d < 3; ++d) centre[d + 1] += with_sign(is_upper(c, d), fourfold[c]);
  }
  return centre;
}

/// 8 r at a corner.
template <class T>
T eightfold_residual(const std::array<T, 4>& centre, const std::array<T, 8>& fourfold,
                     std::size_t corner) {
  T r = T(8) * centre[0] - T(2) * fourfold[corner];
  for (std::size_t d = 0; d < 3; ++d) r += with_sign(is_upper(corner, d), T(T(4) * centre[d + 1]));
  return r;
}

}  // namespace crest::splines
