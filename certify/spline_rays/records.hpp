// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 11, spline-rays, as plain structs (SPEC.md).
#include "certify/exact/spline_volume.hpp"

namespace crest::certify {

inline constexpr std::uint32_t kSplineRays = 11, kSplineRaysVersion = 1;

/// Where a ray meets {s = c} first.
struct SplineHit {
  std::uint32_t cube;        ///< i + nx (j + ny k)
  std::uint8_t tetrahedron;  ///< of the cube, 0 to 23
  double low, high;          ///< the parameter is between them, in multiples of the direction
};

/// Claim spline-rays: the first point of each ray on a level set of a quadratic spline.
struct SplineRaysCertificate {
  SplineVolume volume;
  std::vector<std::array<double, 6>> rays;  ///< a point and a direction, in the world
  std::vector<std::uint8_t> meets;          ///< a ray: 1 a hit, 0 a miss
  std::vector<SplineHit> hits;              ///< a ray with 1, in their order
};

}  // namespace crest::certify
