// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Start triangulations: good triangles in generic position. Their topology is checked, not proven;
// the certificate's conditions prove it (certify/ridges_smooth/SPEC.md, theorem 8).
#include <stdexcept>
#include <vector>

#include "algorithms/smooth_ridges/projection.hpp"

namespace crest::smooth_ridges {

/// Why no triangulation can be made; one line, with coordinates.
class MeshError : public std::runtime_error {
 public:
  enum class Reason {
    empty,     ///< F has no zero in the box
    boundary,  ///< S reaches the box's boundary
    rough      ///< no grid that was tried resolves S: perhaps it is singular
  };
  MeshError(Reason reason, const std::string& what) : std::runtime_error(what), reason_(reason) {}
  Reason reason() const { return reason_; }

 private:
  Reason reason_;
};

/// About `target` faces, more where S bends or two of its parts come close.
/// Parametric: a grid whose cells are near square in space, each cut along its shorter diagonal,
/// its vertices moved off symmetric positions by a fixed pattern; vertices of a boundary move along
/// it.
/// Implicit: a surface net (one vertex a cell that S crosses) of a grid in generic position, on a
/// box around all sign changes and all of `points`; refined until every face's normal agrees with
/// grad F at its corners and a vertex stands near each of `points`; vertices relaxed along S, edges
/// flipped to Delaunay. `points`: points of S known otherwise, at least one a component. Faces are
/// counter-clockwise seen from F > 0.
/// Throws: MeshError (implicit); std::invalid_argument unless 8 <= target <= 10^7.
/// Deterministic.
Triangulation initial_mesh(const Surface& surface, int target,
                           const std::vector<Vec3>& points = {});

/// Parametric surfaces.
Triangulation grid_mesh(const Surface& surface, int target);

}  // namespace crest::smooth_ridges
