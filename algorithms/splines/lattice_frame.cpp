// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/lattice_frame.hpp"

#include "algorithms/splines/exact_frame.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::splines {

using kernel::operator*;
using kernel::operator+;
using kernel::operator-;

ExactFrame::ExactFrame(const kernel::SampledGrid& grid, int first)
    : origin_(grid.origin), first_(first) {
  auto& m = steps_;
  for (std::size_t k = 0; k < 3; ++k)
    m[k] = Rational(grid.spacing[k]) * kernel::lift<Rational>(grid.directions[k]);
  determinant_ = kernel::determinant(m[0], m[1], m[2]);
  if (determinant_ == 0) throw kernel::InputError("axes: lie in a plane; correct the header");
  for (std::size_t k = 0; k < 3; ++k)
    inverse_[k] = Rational(2) / determinant_ * kernel::cross(m[(k + 1) % 3], m[(k + 2) % 3]);
}

ExactPoint ExactFrame::to_lattice(const Vec3& p) const {
  const ExactPoint from_origin = kernel::lift<Rational>(p) - kernel::lift<Rational>(origin_);
  ExactPoint x;
  for (std::size_t k = 0; k < 3; ++k)
    x[k] = kernel::dot(inverse_[k], from_origin) + Rational(1 - 2 * first_);
  return x;
}

ExactPoint ExactFrame::direction_to_lattice(const Vec3& d) const {
  const ExactPoint direction = kernel::lift<Rational>(d);
  ExactPoint x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = kernel::dot(inverse_[k], direction);
  return x;
}

ExactPoint ExactFrame::to_world(const ExactPoint& lattice) const {
  ExactPoint p = kernel::lift<Rational>(origin_);
  for (std::size_t k = 0; k < 3; ++k)
    p = p + (lattice[k] + Rational(2 * first_ - 1)) / Rational(2) * steps_[k];
  return p;
}

LatticeFrame::LatticeFrame(const kernel::SampledGrid& grid, int first)
    : origin_(grid.origin), first_(first) {
  for (std::size_t k = 0; k < 3; ++k) steps_[k] = grid.spacing[k] * grid.directions[k];
  const ExactFrame exact(grid, first);
  mirrored_ = exact.determinant() < 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational& x = exact.inverse()[k][j];
      inverse_[k][j] = static_cast<double>(x);
      low_[k][j] = static_cast<double>(Rational(x - Rational(inverse_[k][j])));
    }
}

Vec3 LatticeFrame::to_lattice(const Vec3& p) const {
  const Vec3 from_origin = p - origin_;
  Vec3 x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = kernel::dot(inverse_[k], from_origin) + shift();
  return x;
}

Vec3 LatticeFrame::to_world(const Vec3& lattice) const {
  Vec3 p = origin_;
  for (std::size_t k = 0; k < 3; ++k) p = p + (0.5 * (lattice[k] - shift())) * steps_[k];
  return p;
}

Vec3 LatticeFrame::gradient_to_world(const Vec3& g) const {
  return g[0] * inverse_[0] + g[1] * inverse_[1] + g[2] * inverse_[2];
}

}  // namespace crest::splines
