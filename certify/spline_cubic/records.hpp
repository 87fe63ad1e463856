// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 12, spline-cubic, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kSplineCubic = 12, kSplineCubicVersion = 1;

/// Cubes first .. first + length - 1.
struct SplineCubeRun {
  std::uint32_t first, length;
};

/// A cubic spline in its normal form, and the samples it is compared with. Vertices and cubes are
/// numbered x fastest.
struct SplineCubicData {
  std::array<double, 6> box{};           ///< x0 x1 y0 y1 z0 z1
  std::array<std::uint32_t, 3> cubes{};  ///< along each axis
  std::vector<SplineCubeRun> domain;     ///< ascending, apart; all cubes: one run
  bool integers = false;                 ///< all numbers below are multiples of u or parts of it
  std::int32_t exponent = 0;             ///< u = 2^exponent; 0 without integers
  std::vector<std::array<double, 4>> vertices;  ///< f, g: a(AAX) = f + g (X - A)
  std::vector<std::array<double, 6>> slopes;    ///< of the edges from a vertex to +x, +y, +z
  std::vector<std::array<double, 4>> centres;   ///< f, g: a(CCX) = f + g (X - C)
  std::vector<std::array<double, 4>> samples;   ///< x, y, z, value; in the closed domain
  std::uint64_t outside = 0;                    ///< samples elsewhere, which are not written
};

/// Claim spline-cubic: how far the spline is from C1 and from its samples.
struct SplineCubicCertificate {
  SplineCubicData data;
  double jump = 0;   ///< no gradient jumps by more than this; 0: the spline is C1
  double error = 0;  ///< no sample differs from the spline by more than this
};

}  // namespace crest::certify
