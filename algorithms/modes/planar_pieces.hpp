// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangulations of planar polygons with holes: constrained Delaunay, with a new vertex on every
// diagonal whose ends lie on one facet of the cell (the neighbour there could have the same
// diagonal, and the surface would meet itself).
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace crest::modes {

struct PlanarPiece {
  std::vector<std::array<double, 2>> points;
  std::vector<std::uint8_t> facets;  ///< bit i: the point lies on facet i of the cell
  /// Of points, each point in one loop once; points behind them that are in none lie inside.
  std::vector<std::vector<std::size_t>> loops;
};

/// New points are appended to the piece's, without facets. Triangles are anticlockwise. Nothing if
/// the loops are not simple, or not nested as one domain's outer and inner boundaries.
std::optional<std::vector<std::array<std::size_t, 3>>> triangulate(PlanarPiece& piece);

/// The same points laid out as circles, one around the others: always a domain.
PlanarPiece laid_out(const PlanarPiece& piece);

}  // namespace crest::modes
