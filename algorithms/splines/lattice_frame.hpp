// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the lattice of a partition lies in the world: p = origin + M v with v the index of a
// sample, X = 2 (v - first) + 1 its lattice point. M's columns are spacings times directions; it
// and its inverse are rounded once.
#include <array>

#include "kernel/geometry/sampled_grid.hpp"

namespace crest::splines {

using kernel::Vec3;

class LatticeFrame {
 public:
  LatticeFrame() = default;
  /// `first`: the sample in the middle of cube 0. Throws: kernel::InputError where M is singular.
  LatticeFrame(const kernel::SampledGrid& grid, int first);

  const Vec3& origin() const { return origin_; }
  /// Columns of M.
  const std::array<Vec3, 3>& steps() const { return steps_; }
  int first() const { return first_; }
  /// 2 M^-1, entry (row, column); `low` is what rounding took away, rounded.
  const std::array<Vec3, 3>& inverse() const { return inverse_; }
  const std::array<Vec3, 3>& inverse_low() const { return low_; }
  /// The lattice point of the world's origin less M^-1 (-origin): 1 - 2 first.
  double shift() const { return 1 - 2 * first_; }
  bool mirrored() const { return mirrored_; }  ///< det M < 0

  Vec3 to_lattice(const Vec3& p) const;
  Vec3 to_world(const Vec3& lattice) const;
  /// A gradient by lattice coordinates as one by world coordinates.
  Vec3 gradient_to_world(const Vec3& g) const;

 private:
  Vec3 origin_{};
  std::array<Vec3, 3> steps_{}, inverse_{}, low_{};
  int first_ = 0;
  bool mirrored_ = false;
};

}  // namespace crest::splines
