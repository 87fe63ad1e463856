// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Start triangulations: good triangles in generic position. Their topology is checked, not proven;
// the certificate's conditions prove it (certify/ridges_smooth/SPEC.md, theorem 8).
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/smooth_ridges/graded_grid.hpp"
#include "algorithms/smooth_ridges/stop.hpp"

namespace crest::smooth_ridges {

/// As messages name a place.
std::string text(const Vec3& p);

/// Why no triangulation can be made; one line, with coordinates.
class MeshError : public std::runtime_error {
 public:
  enum class Reason {
    empty,     ///< F has no zero in the box
    boundary,  ///< S reaches the box's boundary
    rough,     ///< no grid that was tried resolves S: perhaps it is singular
    stopped
  };
  MeshError(Reason reason, const std::string& what) : std::runtime_error(what), reason_(reason) {}
  Reason reason() const { return reason_; }

 private:
  Reason reason_;
};

/// Points of S known otherwise, at least one a component, with the size of what is there (0: not
/// known), and places where cells are to be so small.
struct StartPoints {
  std::vector<FineSpot> known, fine;
};

/// About `target` faces, more where S bends, is small, or two of its parts come close.
/// Parametric: a grid whose cells are near square in space, each cut along its shorter diagonal,
/// its vertices moved off symmetric positions by a fixed pattern; vertices of a boundary move along
/// it.
/// Implicit: a surface net (one vertex a sheet and cell) of a grid in generic position, on a box
/// around all sign changes and all known points. The grid's cells are halved where the net is no
/// manifold, a vertex does not reach S, a face's normal does not agree with grad F at its corners,
/// or no vertex stands near a known point; then vertices are relaxed along S, edges flipped to
/// Delaunay. Faces are counter-clockwise seen from F > 0.
/// Throws: MeshError (implicit); std::invalid_argument unless 8 <= target <= 10^7.
/// Deterministic.
Triangulation initial_mesh(const Surface& surface, int target, const StartPoints& points = {},
                           const Stop& stop = {});

/// Parametric surfaces.
Triangulation grid_mesh(const Surface& surface, int target);

}  // namespace crest::smooth_ridges
