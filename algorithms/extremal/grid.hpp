// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The uniform grid: nodes numbered x fastest, cells by their lowest node, edges 3 node + axis from
// their lower end, faces 3 node + normal axis from their lowest node. An image has one layer of
// nodes, no edge along z and no cell; its squares are the faces across z.
#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::extremal {

using kernel::Index;
using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

using Node = std::array<int, 3>;
inline Vec3 as_vector(const Node& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}

class Grid {
 public:
  Grid(const std::array<Index, 3>& size, const Vec3& spacing, const Vec3& origin)
      : size{static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2])},
        stride{1, size[0], std::size_t{size[0]} * size[1]},
        spacing(spacing),
        origin(origin) {
    // Nothing changes along it, so any will do; bounds of roundings are relative to the least.
    if (size[2] == 1) this->spacing[2] = spacing[0] < spacing[1] ? spacing[0] : spacing[1];
  }

  int dimension() const { return size[2] == 1 ? 2 : 3; }
  std::size_t nodes() const { return stride[2] * static_cast<std::size_t>(size[2]); }
  std::size_t index(const Node& v) const {
    return static_cast<std::size_t>(v[0]) + stride[1] * static_cast<std::size_t>(v[1]) +
           stride[2] * static_cast<std::size_t>(v[2]);
  }
  Node node(std::size_t i) const {
    return {static_cast<int>(i % stride[1]), static_cast<int>(i % stride[2] / stride[1]),
            static_cast<int>(i / stride[2])};
  }
  Vec3 position(const Vec3& x) const {
    return {origin[0] + spacing[0] * x[0], origin[1] + spacing[1] * x[1],
            origin[2] + spacing[2] * x[2]};
  }
  /// Is v the lowest node of a cell?
  bool is_cell(const Node& v) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (v[k] < 0 || v[k] >= size[k] - 1) return false;
    return true;
  }
  /// Of the square across z at v, or the cell.
  bool is_square(const Node& v) const {
    return v[0] >= 0 && v[1] >= 0 && v[0] < size[0] - 1 && v[1] < size[1] - 1;
  }

  std::array<int, 3> size;
  std::array<std::size_t, 3> stride;
  Vec3 spacing, origin;
};

inline Node as_node(const std::array<Index, 3>& v) {
  return {static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2])};
}

/// The other two axes, in cyclic order.
constexpr std::size_t next(std::size_t axis) {
  return axis == 2 ? 0 : axis + 1;
}
constexpr std::size_t after_next(std::size_t axis) {
  return axis == 0 ? 2 : axis - 1;
}

}  // namespace crest::extremal
