// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where there is room for another fishbone: the free point farthest from everything.
#include <optional>
#include <vector>

#include "algorithms/line_art/tracer.hpp"

namespace crest::line_art {

/// On cells of half a spacing, with their chamfer distances (3 and 4 to the cell, within 8 % of the
/// true ones) to what is taken: paper, highlights, contours, singularities, and what take() took.
/// Cost: of all calls together, a few steps a cell.
class FreeRoom {
 public:
  FreeRoom(const Tracer& tracer, double brightest);
  /// Cells within a radius that no contour separates from p.
  void take(const Vec2& p, double radius);
  /// The middle of the free cell farthest from what is taken, if that is farther than `least`.
  std::optional<Vec2> farthest(double least);

 private:
  Vec2 centre(int i, int j) const { return {(i + 0.5) * cell_, (j + 0.5) * cell_}; }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(i);
  }

  /// Is taken from now on; what it is near is nearer.
  void set_taken(std::size_t cell);
  void spread();

  const Barriers& barriers_;
  double cell_;
  int columns_, rows_;
  std::vector<int> distance_;                      ///< 0: taken
  std::vector<std::vector<std::size_t>> waiting_;  ///< by distance: their neighbours may be nearer
  std::vector<int> farthest_;                      ///< in each row; -1: to be found anew
};

}  // namespace crest::line_art
