// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces of a grid: the nodes that a piece owns, and round them a halo of nodes that others own.
//
// What is decided of an owned node from nodes within the halo is what the whole grid decides, if
// the piece numbers its nodes in the whole grid's order (ties, sums and walks then run as there)
// and knows the borders of the grid from its own.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::kernel {

using GridSize = std::array<Index, 3>;

/// Nodes low .. high - 1 along each axis.
struct GridBox {
  GridSize low{}, high{};

  GridSize size() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }
  std::uint64_t nodes() const {
    const GridSize n = size();
    return std::uint64_t{n[0]} * n[1] * n[2];
  }
  bool has(const GridSize& v) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (v[k] < low[k] || v[k] >= high[k]) return false;
    return true;
  }
  friend bool operator==(const GridBox&, const GridBox&) = default;
};

struct GridPiece {
  GridSize size;  ///< of the whole grid
  GridBox owned;
  GridBox all;  ///< owned and halo
};

inline GridPiece whole_grid(const GridSize& size) {
  return {size, {{}, size}, {{}, size}};
}

/// `halo`: nodes beyond those that are owned, as far as the grid goes.
inline GridPiece with_halo(const GridSize& size, const GridBox& owned, Index halo) {
  GridPiece r{size, owned, owned};
  for (std::size_t k = 0; k < 3; ++k) {
    r.all.low[k] = owned.low[k] - std::min(owned.low[k], halo);
    r.all.high[k] = owned.high[k] + std::min(size[k] - owned.high[k], halo);
  }
  return r;
}

/// How many parts along each axis make `count` boxes with the least surface. Parts of less than one
/// node are not made: there may be fewer boxes.
GridSize parts_of(const GridSize& size, Index count);

/// Boxes that own every node once, x fastest; sizes along an axis differ by one at most.
std::vector<GridBox> cut_grid(const GridSize& size, const GridSize& parts);

}  // namespace crest::kernel
