// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the mesh's vertices are put in cells, and what the fields have there.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "algorithms/extremal/fields.hpp"

namespace crest::extremal {

/// Places on edges and in cells are written in 65536ths.
inline constexpr double kPlaces = 65536;

/// Inside the edge: at a node the fans of several edges would meet.
inline std::uint16_t snapped(double x) {
  return static_cast<std::uint16_t>(std::clamp(std::round(x * kPlaces), 1.0, kPlaces - 1));
}
/// A place on an edge, in units of the grid.
inline Vec3 zero_at(const Grid& grid, Index edge, std::uint16_t place) {
  Vec3 x = as_vector(grid.node(edge / 3));
  x[edge % 3] += place / kPlaces;
  return x;
}

/// A sheet's vertex in a cell, by 1/64 inside it at least: from `centre`, that of its zeros, along
/// n to g = 0. `zeros` (places in the cell) where no cone holds n in the cell, else none: then the
/// vertex is put where n continues that of one of them, for its level is that of n at its place;
/// the place above, from a point nearer to a zero, that point, next to a zero, the first that will
/// do.
Vec3 vertex_place(const Fields& fields, const Node& cell, const Vec3& centre,
                  std::span<const Vec3> zeros);

/// What is kept of the mesh.
struct Levels {
  std::optional<double> value;  ///< keeps L >= it
  double strength = 0;          ///< keeps s_nn >= it, if positive
  bool any() const { return value || strength > 0; }
};
/// min(L - value, s_nn - strength), each only if given: kept is where it is 0 at least.
double level_at(const Fields& fields, const Levels& levels, const Node& cell, const Vec3& t);

/// What a result has at a place.
struct AtPlace {
  Vec3 normal;         ///< n, in either orientation
  double slope, bend;  ///< g and s_nn
  double s, plateness;
};
AtPlace at_place(const Local& local, bool plane);

}  // namespace crest::extremal
