// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 13, spline-isosurface, as plain structs (SPEC.md).
#include "certify/exact/spline_volume.hpp"

namespace crest::certify {

inline constexpr std::uint32_t kSplineIsosurface = 13, kSplineIsosurfaceVersion = 1;

/// Of a node in a tree of bisections, in preorder.
namespace spline_code {
inline constexpr std::uint8_t kLeaf = 0, kBisected = 1;
}

/// Claim spline-isosurface: the topology of a level set of a quadratic spline, as a mesh.
struct SplineIsosurfaceCertificate {
  SplineVolume volume;
  std::vector<std::uint32_t> bisected;  ///< tetrahedra with a tree, ascending: 24 cube + number
  std::vector<std::uint8_t> trees;      ///< their trees in preorder
  std::vector<std::array<double, 2>> brackets;          ///< a vertex: where on its edge
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< in the order of the leaves
  std::int32_t euler_characteristic = 0;
  std::uint32_t components = 0, boundary_loops = 0;
};

}  // namespace crest::certify
