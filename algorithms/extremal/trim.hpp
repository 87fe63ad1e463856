// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mesh cut at the levels: polygons wholly kept as they are, others as parts of the triangles of
// their fans (an image: of their halves), cut linearly.
#include "algorithms/extremal/sheet_mesh.hpp"

namespace crest::extremal {

/// A vertex of the cut mesh: the mesh's own first, in their order.
struct TrimmedPoint {
  Vec3 place;  ///< in units of the grid
  Node cell;   ///< which has it
};
struct TrimmedMesh {
  std::vector<TrimmedPoint> points;
  std::vector<Index> first{0}, corners;  ///< polygons; an image: segments
  std::vector<Index> source;             ///< a polygon's in the sheet mesh, ascending
  std::vector<Feature> features;
  std::vector<bool> partly;              ///< a sheet polygon's: something of it is cut off
  std::array<std::size_t, 4> valence{};  ///< as in Counts
  std::array<std::size_t, 5> reasons{};  ///< edges of valence 1 by reason
};

struct Levels {
  std::optional<double> value;  ///< keeps L >= it
  double strength = 0;          ///< keeps s_nn >= it, if positive
  bool any() const { return value.has_value() || strength > 0; }
};

TrimmedMesh trim(const Fields& fields, const SheetMesh& mesh, const Levels& levels);

/// The zero of a polygon: its cell and its place there.
std::pair<Node, Vec3> zero_of(const Grid& grid, const SheetPolygon& p);

}  // namespace crest::extremal
