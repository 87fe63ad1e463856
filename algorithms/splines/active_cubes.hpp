// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Active cubes, those that a level set may meet, as a tree of bits: a node is a word of 4 x 4 x 4
// bits, one a child that has any.
#include <functional>
#include <vector>

#include "algorithms/splines/quadratic.hpp"

namespace crest::splines {

/// Calls work(y, z, low, high) for each row of cubes along the first axis: bounds of all
/// coefficients less c, times `scale`, off by at most 2^-20 of the largest such. By threads.
/// Requires: a power of two, by which this largest is within floats' normal numbers.
/// Cost: 12 ns a cube.
using RowWork =
    std::function<void(int y, int z, std::span<const float> low, std::span<const float> high)>;
void for_each_row_hull(const QuadraticSpline& spline, double c, double scale, const RowWork& work);

/// The power of two that takes a number to [1, 2), or nearly for those at the ends of doubles; 1
/// for 0 and infinity.
double scale_to_one(double largest);

class ActiveCubes {
 public:
  /// Cubes whose coefficients, less c, are not all beyond the margin on one side.
  ActiveCubes(const QuadraticSpline& spline, double c);

  /// Every coefficient of a cube without a bit differs from c by more, all to one side.
  double margin() const { return margin_; }
  double largest() const { return largest_; }  ///< bound of |coefficient - c|
  double range() const { return range_; }      ///< bound of coefficients' differences
  std::size_t count() const { return count_; }

  int levels() const { return static_cast<int>(levels_.size()); }
  /// Level 0: words of cubes; each next one of words of the level before. The last is one word.
  std::uint64_t word(int level, int x, int y, int z) const {
    const Level& l = levels_[static_cast<std::size_t>(level)];
    return l.words[static_cast<std::size_t>(x + l.size[0] * (y + l.size[1] * z))];
  }
  bool active(const Cube& c) const {
    return word(0, c[0] >> 2, c[1] >> 2, c[2] >> 2) >> bit(c[0], c[1], c[2]) & 1;
  }
  static int bit(int x, int y, int z) { return (x & 3) | (y & 3) << 2 | (z & 3) << 4; }

 private:
  struct Level {
    std::array<int, 3> size;
    std::vector<std::uint64_t> words;
  };
  std::vector<Level> levels_;
  double margin_ = 0, largest_ = 0, range_ = 0;
  std::size_t count_ = 0;
};

}  // namespace crest::splines
