// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sides of triangles, sorted so that those of one edge stand together, and what lies across.
#include "io/clean/surface.hpp"

namespace crest::io {

/// A side of a face: its ends, the smaller one first, and the third corner.
struct Side {
  kernel::Index low, high, third, face;
  std::uint8_t corner;  ///< it begins there
  bool direct;          ///< and runs from low to high
};

/// 3F, by low, high, third and face. Cost: O(F log F), linear for bounded valences.
std::vector<Side> sorted_sides(const Surface& surface);

/// One past the last side of the edge to which sides[i] belongs.
std::size_t edge_end(const std::vector<Side>& sides, std::size_t i);

/// The face across a side, or none: at the boundary, and at edges of three or more faces.
struct Neighbour {
  kernel::Index face = kernel::kNone;
  std::uint8_t side = 0;  ///< of that face
  bool agrees = true;     ///< the two run along the side in opposite directions
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours neighbours(const std::vector<Side>& sides);

}  // namespace crest::io
