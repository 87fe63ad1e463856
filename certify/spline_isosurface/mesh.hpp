// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Leaves that hold a part of the surface, and the mesh (SPEC.md, steps 3 to 5).
#include "certify/spline_isosurface/forest.hpp"

namespace crest::certify::spline_isosurface {

/// A leaf whose corners have both signs.
struct ActiveLeaf {
  std::uint32_t root;
  Simplex simplex;
  unsigned negative;  ///< bits of the corners where s < c
};

struct Leaves {
  std::vector<ActiveLeaf> active;  ///< in their order
  std::size_t simple = 0;          ///< not empty; some hold no part of the surface
};

/// Throws Reject unless every leaf is empty or simple. Cost: 5 microseconds a cube whose
/// coefficients have both signs; rationals where intervals do not decide.
Leaves check_leaves(const SplineVolume& volume, const QuadraticSpline& spline,
                    const Forest& forest);

/// The triangles in their order, and where each vertex is.
struct Mesh {
  struct Vertex {
    std::size_t leaf;                 ///< among the active ones
    std::array<std::size_t, 2> ends;  ///< from the lower end of the edge to the upper one
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// Requires: the leaves conform. Cost: n log n.
Mesh build_mesh(const Leaves& leaves, kernel::Sign orientation);

/// Throws Reject unless every bracket holds the zero of s - c on its edge.
void check_brackets(const SplineIsosurfaceCertificate& certificate, const QuadraticSpline& spline,
                    const Forest& forest, const Leaves& leaves, const Mesh& mesh);

}  // namespace crest::certify::spline_isosurface
