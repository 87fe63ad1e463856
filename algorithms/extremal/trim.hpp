// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mesh cut at the levels: polygons wholly kept as they are, others as parts of the triangles of
// their fans (an image: of their halves), cut linearly.
#include "algorithms/extremal/sheet_mesh.hpp"

namespace crest::extremal {

struct TrimmedMesh {
  std::vector<Vec3> points;              ///< in units of the grid; the mesh's own first
  std::vector<Index> first{0}, corners;  ///< polygons; an image: segments
  std::vector<Index> source;             ///< a polygon's in the sheet mesh, ascending
  std::vector<Feature> features;
  std::vector<bool> partly;              ///< a sheet polygon's: something of it is cut off
  std::array<std::size_t, 4> valence{};  ///< as in Counts
  std::array<std::size_t, 5> reasons{};  ///< edges of valence 1 by reason
  std::size_t unexplained = 0;           ///< edges of other valence than 2 without a reason
};

/// What is kept: where a function is at least 0.
struct LevelValues {
  std::vector<double> corners,
      centres;  ///< at the vertices, at the polygons' zeros; none: all kept
};

/// Takes the mesh's points.
TrimmedMesh trim(SheetMesh& mesh, const LevelValues& values);

}  // namespace crest::extremal
