// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What lies round an edge of the grid: the cells in cyclic order, and the faces between them; in an
// image the two squares, each its own face.
#include "algorithms/extremal/grid.hpp"

namespace crest::extremal {

class Dual {
 public:
  struct Side {
    Node face;
    std::size_t normal;
  };
  explicit Dual(const Grid& grid) : sides(grid.dimension() == 2 ? 2 : 4), grid_(grid) {}

  /// Cells at an edge; an image: squares, of which there are two.
  std::array<Node, 4> cells_at(Index e) const {
    const Node v = grid_.node(e / 3);
    const std::size_t a = e % 3, b = next(a), c = after_next(a);
    if (plane()) return {minus(v, 1 - a), v, v, v};
    return {minus(minus(v, b), c), minus(v, c), v, minus(v, b)};
  }
  /// From cell i of cells_at to the next; an image: the square itself.
  Side side_at(Index e, std::size_t i) const {
    const Node v = grid_.node(e / 3);
    const std::size_t a = e % 3, b = next(a), c = after_next(a);
    if (plane()) return {i == 0 ? minus(v, 1 - a) : v, 2};
    switch (i) {
      case 0:
        return {minus(v, c), b};
      case 1:
        return {v, c};
      case 2:
        return {v, b};
      default:
        return {minus(v, b), c};
    }
  }
  std::array<Index, 4> edges_of(const Side& s) const {
    const std::size_t a = next(s.normal), b = after_next(s.normal), at = grid_.index(s.face);
    return {static_cast<Index>(3 * at + a), static_cast<Index>(3 * (at + grid_.stride[a]) + b),
            static_cast<Index>(3 * (at + grid_.stride[b]) + a), static_cast<Index>(3 * at + b)};
  }
  bool inside(const Node& cell) const {
    return plane() ? grid_.is_square(cell) : grid_.is_cell(cell);
  }
  bool plane() const { return sides == 2; }

  const std::size_t sides;  ///< how many cells are round an edge

 private:
  static Node minus(Node v, std::size_t axis) {
    --v[axis];
    return v;
  }
  const Grid& grid_;
};

}  // namespace crest::extremal
