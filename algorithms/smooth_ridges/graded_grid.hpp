// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A grid of cubes, finer where small things are known to be: cubes of a coarse grid cut into eight,
// again and again (an octree on each). A function is sampled at the corners of its cells.
//
// Coordinates of points and cells are whole numbers of the smallest cube's side. The pieces that
// cells share are *whole*: an edge is cut in two, a side in four, where a finer cell meets it,
// which is where its middle is a corner of a cell.
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "algorithms/smooth_ridges/projection.hpp"

namespace crest::smooth_ridges {

/// Cells of side `cell` along three orthonormal axes; point (i, j, k) is origin + cell (i a0 +
/// ...).
struct Grid {
  Vec3 origin;
  std::array<Vec3, 3> axes;
  double cell;
  std::array<std::size_t, 3> points;  ///< along each axis

  std::size_t size() const { return points[0] * points[1] * points[2]; }
  Vec3 at(double i, double j, double k) const {
    return origin + cell * i * axes[0] + cell * j * axes[1] + cell * k * axes[2];
  }
};

/// A grid turned by a fixed rotation, and shifted, so that no symmetric surface is symmetric to it;
/// covers the points low..high measured along its axes.
Grid generic_grid(const Vec3& low, const Vec3& high, double cell);
/// The coordinates of a point along the axes of generic_grid().
Vec3 along_generic_axes(const Vec3& p);

/// Cells at `place` are to be no larger than `size`; with the distance they may grow.
struct FineSpot {
  Vec3 place;
  double size;
};

/// F on a grid; outside the box at the nearest point of the box.
class GradedGrid {
 public:
  using Coordinates = std::array<std::uint32_t, 3>;
  struct Cell {
    Coordinates low;
    std::uint32_t side;
  };

  /// Cells are cut 20 times at most, or until coordinates need more than 31 bits.
  GradedGrid(Projection& f, const Surface::Box& box, const Grid& grid,
             const std::vector<FineSpot>& spots);

  /// Of the cells that are not cut.
  std::uint32_t unit() const { return std::uint32_t{1} << depth_; }
  /// Cells that are smaller.
  const std::vector<Cell>& small_cells() const { return small_; }
  /// The last point along the axis.
  std::uint32_t end(std::size_t axis) const {
    return static_cast<std::uint32_t>(grid_.points[axis] - 1) << depth_;
  }
  bool is_corner(const Coordinates& p) const { return is_coarse(p) || fine_.contains(p); }
  /// Requires: is_corner(p).
  double value(const Coordinates& p) const {
    return is_coarse(p) ? coarse_[number(p)] : fine_.at(p);
  }
  Vec3 place(const Coordinates& p) const;
  /// The cell that holds the smallest cube above p. Requires: there is one.
  Cell cell_above(const Coordinates& p) const;
  double side_in_space(const Cell& c) const { return grid_.cell * c.side / unit(); }

 private:
  struct Hash {
    std::size_t operator()(const Coordinates& p) const {
      std::uint64_t h = 0;
      for (const std::uint32_t x : p) h = (h ^ x) * 0x9e3779b97f4a7c15u, h ^= h >> 32;
      return h;
    }
  };

  bool is_coarse(const Coordinates& p) const { return ((p[0] | p[1] | p[2]) & (unit() - 1)) == 0; }
  std::size_t number(const Coordinates& p) const {
    return (std::size_t{p[0] >> depth_} * grid_.points[1] + (p[1] >> depth_)) * grid_.points[2] +
           (p[2] >> depth_);
  }
  double sample(const Coordinates& p);
  void cut_near(const std::vector<FineSpot>& spots);
  void divide(const Cell& c, const std::vector<FineSpot>& spots);

  Projection& f_;
  const Surface::Box& box_;
  Grid grid_;
  unsigned depth_ = 0;
  std::vector<double> coarse_;
  std::vector<Cell> small_;
  std::unordered_map<Coordinates, double, Hash> fine_;               ///< corners of small cells
  std::unordered_map<Coordinates, std::uint32_t, Hash> small_side_;  ///< by low
};

}  // namespace crest::smooth_ridges
