// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Level lines of a piecewise quadratic function: arcs of conics with the exact topology.
#include <vector>

#include "algorithms/reeb/tile_complex.hpp"

namespace crest::reeb {

/// One component of a level set.
struct Contour {
  bool closed;                       ///< the last point joins the first
  std::vector<kernel::Vec3> points;  ///< on the faces, in order
};

/// How many nodes have a value less than `level`, decided exactly: the others are above.
/// Cost: O(log n) rationals.
Index nodes_below(const kernel::QuadraticMesh& mesh, const TileComplex& tiles, double level);

/// The components of the level set at `level`; nodes at exactly that value count as above, so each
/// line is a path between boundary edges or a cycle.
/// Guarantees: which edges a line crosses, and which crossings a face joins, is exact (SPEC.md,
///   theorem 4); places are rounded. Paths first, then cycles, each by its least side; the same for
///   any order of the faces.
/// Requires: level finite. Cost: O(n + k log k) for k crossings.
std::vector<Contour> contours(const kernel::QuadraticMesh& mesh, const TileComplex& tiles,
                              double level);

}  // namespace crest::reeb
