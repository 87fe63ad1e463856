// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of the integer points of a box of which few have one: blocks of 4 x 4 x 4 points, made
// where one is needed. A look-up is two reads, and what is near in space is near in memory.
#include <array>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::splines {

class IndexBlocks {
 public:
  using Point = std::array<int, 3>;

  /// Points from 0 to size - 1 along each axis.
  explicit IndexBlocks(const Point& size) {
    for (std::size_t k = 0; k < 3; ++k) size_[k] = (static_cast<std::size_t>(size[k]) + 3) / 4;
  }

  /// kNone where there is none.
  kernel::Index find(const Point& at) const {
    if (blocks_.empty()) return kernel::kNone;
    const kernel::Index block = blocks_[block_of(at)];
    return block == kernel::kNone ? kernel::kNone : numbers_[block][place_in_block(at)];
  }

  /// The number, to be changed.
  kernel::Index& operator[](const Point& at) {
    if (blocks_.empty()) blocks_.assign(size_[0] * size_[1] * size_[2], kernel::kNone);
    kernel::Index& block = blocks_[block_of(at)];
    if (block == kernel::kNone) {
      block = static_cast<kernel::Index>(numbers_.size());
      numbers_.emplace_back().fill(kernel::kNone);
    }
    return numbers_[block][place_in_block(at)];
  }

 private:
  std::size_t block_of(const Point& at) const {
    const auto k = [&](std::size_t axis) { return static_cast<std::size_t>(at[axis]) >> 2; };
    return k(0) + size_[0] * (k(1) + size_[1] * k(2));
  }
  static std::size_t place_in_block(const Point& at) {
    return static_cast<std::size_t>((at[0] & 3) | (at[1] & 3) << 2 | (at[2] & 3) << 4);
  }

  std::array<std::size_t, 3> size_;    ///< in blocks
  std::vector<kernel::Index> blocks_;  ///< none until there is a number
  std::vector<std::array<kernel::Index, 64>> numbers_;
};

}  // namespace crest::splines
