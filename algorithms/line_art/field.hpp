// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The field of hatching directions on a surface: principal directions where curvature says
// something, smooth elsewhere, circles of latitude where it says nothing.
#include <vector>

#include "algorithms/line_art/view.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::line_art {

/// Of a curvature estimate, one a vertex.
struct PrincipalFrame {
  double k1 = 0, k2 = 0;
  Vec3 d1{}, d2{}, n{};
};

struct FieldOptions {
  bool cross = false;                 ///< the pair of directions; else the line of larger |k|
  double spacing = 1;                 ///< of hatches, in the mesh's units
  double smooth = 5;                  ///< L, the same
  Vec3 axis{0, 1, 0};                 ///< of the latitude circles
  std::optional<double> crease = 60;  ///< degrees: no coupling across sharper edges
};

struct DirectionField {
  int symmetry = 2;             ///< 2: lines, 4: crosses
  std::vector<Vec3> direction;  ///< V: a representative, unit and tangent
  std::vector<Index> singular;  ///< faces with an index
  std::vector<int> index;       ///< theirs, times the symmetry
  int index_sum = 0;            ///< times the symmetry; closed meshes: Euler characteristic
};

/// Minimises sum A (c |u - u0|^2 + tau |u - up|^2) + L^2 sum w |u_i - r_ij u_j|^2 over u = exp(i N
/// theta) a vertex; README.md has the letters. Indices by star angles
/// (kernel/predicates/rotation.hpp) and the least turn along each edge. Throws: std::runtime_error
/// if the system is not definite.
DirectionField direction_field(const kernel::TriangleMesh& mesh,
                               const std::vector<PrincipalFrame>& frames,
                               const FieldOptions& options);

}  // namespace crest::line_art
