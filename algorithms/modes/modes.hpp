// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public call of mode and neutral surfaces (theory and limits: README.md beside this file).
#include <vector>

#include "algorithms/modes/level.hpp"
#include "algorithms/modes/mode_surface.hpp"
#include "kernel/geometry/tet_mesh.hpp"

namespace crest::modes {

struct Workers;  // pieces.hpp: who tests pieces of the mesh; none: this process

struct ModeField {
  kernel::TetMesh mesh;
  std::vector<std::array<double, 6>> tensors;  ///< a vertex: xx yy zz xy yz xz, finite
};

/// The length of the diagonal of the box around its vertices, in the mesh's unit; 0 without any.
double diagonal(const ModeField& field);

struct ModeOptions {
  int max_depth = 40;              ///< of the bisection of a tetrahedron, at most 255
  std::uint64_t budget = 100'000;  ///< tests of a tetrahedron with its inner faces, of a face
  /// Triangles are refined until they are this near to the surface, as far as their middles and
  /// their edges' tell, in the mesh's unit; 0: not for that.
  double deviation = 0;
};

struct ModeCounts {
  std::size_t total = 0, rejected_bound = 0, rejected_bernstein = 0, active = 0, cones = 0;
  std::size_t graph_at_once = 0, graph_cells = 0, uniform = 0;
  std::uint64_t tests = 0, exact_tests = 0;
  int max_depth = 0;
};

struct ModeResult {
  Level level;
  std::vector<ModeSurface> surfaces;  ///< plus, minus; or the neutral one
  ModeCounts counts;
  std::vector<kernel::Index> undecided;  ///< tetrahedra with open cells, ascending
  bool exhausted = false;                ///< some of them because the budget was spent
};

/// The two surfaces of mode +mu and -mu, or the neutral one.
/// Guarantees: the same result whatever else is asked for and whoever works; topology as README.md
/// states, for all
///   tetrahedra but the undecided ones.
ModeResult extract(const ModeField& field, const Level& level, const ModeOptions& options = {},
                   const Workers* workers = nullptr);

}  // namespace crest::modes
