// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frame of a lattice in rationals: of any two doubles' product no bit is lost.
#include "algorithms/splines/lattice_frame.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::splines {

using kernel::Rational;
using ExactPoint = std::array<Rational, 3>;

class ExactFrame {
 public:
  /// Throws: kernel::InputError where the axes lie in a plane.
  ExactFrame(const Vec3& origin, const std::array<Vec3, 3>& steps, int first);
  const std::array<ExactPoint, 3>& inverse() const { return inverse_; }  ///< 2 M^-1
  const Rational& determinant() const { return determinant_; }
  ExactPoint to_lattice(const Vec3& p) const;
  ExactPoint direction_to_lattice(const Vec3& d) const;

 private:
  Vec3 origin_;
  int first_;
  Rational determinant_;
  std::array<ExactPoint, 3> inverse_;
};

}  // namespace crest::splines
