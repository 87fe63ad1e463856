// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frame of a lattice in rationals: world = origin + sum of index_k (spacing_k direction_k),
// nothing rounded.
#include "algorithms/splines/lattice_frame.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::splines {

using kernel::Rational;
using ExactPoint = std::array<Rational, 3>;

class ExactFrame {
 public:
  /// Throws: kernel::InputError where the axes lie in a plane.
  ExactFrame(const kernel::SampledGrid& grid, int first);
  const std::array<ExactPoint, 3>& inverse() const { return inverse_; }  ///< 2 M^-1
  const Rational& determinant() const { return determinant_; }
  ExactPoint to_lattice(const Vec3& p) const;
  ExactPoint direction_to_lattice(const Vec3& d) const;
  ExactPoint to_world(const ExactPoint& lattice) const;

 private:
  Vec3 origin_;
  int first_;
  Rational determinant_;
  std::array<ExactPoint, 3> steps_, inverse_;
};

}  // namespace crest::splines
