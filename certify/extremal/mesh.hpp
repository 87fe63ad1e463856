// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mesh: polygons of extremal edges, their sides glued by the groups of squares (SPEC.md,
// "Mesh"). For an image a polygon is a segment; then what is said of sides holds for its ends.
#include "certify/extremal/squares.hpp"

namespace crest::certify::extremal {

/// A side of a polygon: on a square. Corner i of a polygon is in cell i round its edge.
struct Side {
  u32 polygon, side;
};
/// Sides that are glued; in a volume an edge of the mesh.
struct Seam {
  std::array<Side, 3> sides;
  std::uint8_t count;   ///< valence
  std::uint8_t reason;  ///< 1 to 5; 0 with valence 2
};
struct Mesh {
  u32 corners;                ///< of a polygon: 4, or 2
  std::vector<u32> polygons;  ///< their edges, ascending
  std::vector<Seam> seams;
  std::vector<u32> vertex;        ///< of corner `corners * polygon + i`
  std::vector<u32> vertex_cells;  ///< of every vertex, ascending
};

/// Corner at the end of a side in the cell below its square and above it; whether the side runs up.
struct SideEnds {
  u32 low, high;
  bool upwards;
};
constexpr SideEnds side_ends(u32 side) {
  constexpr std::array<SideEnds, 4> kEnds = {
      {{0, 1, true}, {1, 2, true}, {3, 2, false}, {0, 3, false}}};
  return kEnds[side];
}

Mesh build_mesh(const Grid& grid, const Edges& edges, const Squares& squares);

}  // namespace crest::certify::extremal
