// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The dual complex before anything is cut: a polygon an edge of the grid, a vertex a sheet of a
// cell, an edge an arc of a face (an image: a segment an edge, a vertex an arc of a square).
#include <vector>

#include "algorithms/extremal/extremal_result.hpp"
#include "algorithms/extremal/records.hpp"

namespace crest::extremal {

/// Never, says proposition 2.
inline constexpr Reason kUnexplained{0};

struct SheetVertex {
  Index cell;                          ///< an image: square; an octree: leaf
  std::array<std::uint16_t, 3> place;  ///< in it, in 65536ths; an octree: unused
};
/// An edge of the mesh; an image: unused.
struct SheetEdge {
  std::array<Index, 2> ends;
  std::uint8_t valence;
  std::uint8_t reason;  ///< 0 with valence 2
  /// Of a twin, whose ends another arc of its face joins, too: which of the middles; else kNone.
  Index middle = kernel::kNone;
};
struct SheetPolygon {
  Index edge;           ///< of the grid
  std::uint16_t place;  ///< of its zero on it, in 65536ths; an octree: unused
  bool extremal;
  Vec3 zero;                     ///< in units of the grid
  std::array<Index, 4> corners;  ///< cyclic; an image: the first two
  std::array<Index, 4> sides;    ///< edges of the mesh: from a corner to the next
  std::uint8_t count = 4;        ///< of corners; an octree: 3 or 4
};

struct SheetMesh {
  int dimension = 3;
  std::vector<SheetPolygon> polygons;  ///< by edge
  std::vector<SheetVertex> vertices;   ///< by cell, then by the lowest edge of their polygons
  std::vector<Vec3> points;            ///< where they are, in units of the grid, until it is cut
  std::vector<Vec3> middles;           ///< places of twins, in units of the grid
  std::vector<SheetEdge> edges;        ///< by their lowest polygon
  /// Of an image's vertices: valence and reason.
  std::vector<std::pair<std::uint8_t, std::uint8_t>> ends;
};

/// Of joined records. `critical`: of all critical edges, else of extremal ones.
SheetMesh make_sheets(const Grid& grid, const Records& records, bool critical);

/// Faces with critical edges, as 3 node + normal, ascending; an image: its squares.
std::vector<Index> crossed_faces(const Fields& fields, const Edges& edges);

}  // namespace crest::extremal
