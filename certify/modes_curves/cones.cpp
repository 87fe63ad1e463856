// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/cones.hpp"

#include <cmath>
#include <limits>

namespace crest::certify::curves {
namespace {

/// The direction's error, in norm; scalar products are then wrong by 2.1 times this.
constexpr double kError = 1e-10;

/// At least the largest y with 4 y^3 - 3 y = |mode|: the cosine of the angle to the nearest
/// degenerate tensor. 2: not below 1.
double cosine_bound(const std::array<double, 6>& u) {
  // u is wrong by kError: det by less than that, mode = 3 sqrt(6) det by less than 7.4 times.
  constexpr double root = 0.70710678118654752;
  const double xy = root * u[3], yz = root * u[4], xz = root * u[5];
  const double det =
      u[0] * (u[1] * u[2] - yz * yz) - xy * (xy * u[2] - yz * xz) + xz * (xy * yz - u[1] * xz);
  const double mode = 7.3484692283495345 * std::fabs(det) + 10 * kError;
  if (!(mode < 1)) return 2;
  const double y = std::cos(std::acos(mode) / 3) + kError;
  // 4 y^3 - 3 y rises from 1/2 on: whatever the library's functions gave, this proves it.
  if (!(y > 0.5 && (4 * y * y - 3) * y > mode + 0x1p-48)) return 2;
  return y;
}

}  // namespace

/// The direction is wrong by kError at most, or is one itself; or it is a mean of n whose product
/// with each is above 0.86: then its length is above 0.86 n, and it is within 1.2 kError of a
/// traceless one, which the 10 kError and 3 kError below cover.
void Cones::normalise(Axis& axis) {
  double squares = 0;
  for (const double x : axis.direction) squares += x * x;
  const double norm = std::sqrt(squares);
  for (double& x : axis.direction) x /= norm;
  axis.cosine = squares > 0x1p-7 ? cosine_bound(axis.direction) + 3 * kError : 2;
}

Cones::Cones(const modes::Field& field) {
  axes_.reserve(field.fixed());
  for (std::uint32_t v = 0; v < field.fixed(); ++v) {
    const auto& t = field.approximate(v);
    // Entries wrong by e turn the vector by at most 6 e / |D|, |D| >= 0.9 largest.
    const bool known = t.error < 0x1p-37 * t.largest && t.largest > 0x1p-900;
    Axis axis{{}, 2};
    axis.direction.fill(std::numeric_limits<double>::quiet_NaN());
    if (known) {
      int exponent = 0;
      std::frexp(t.largest, &exponent);
      for (std::size_t k = 0; k < 6; ++k)
        axis.direction[k] = std::ldexp(t.entries[k], -exponent) * (k < 3 ? 1 : 1.4142135623730951);
      normalise(axis);
    }
    axes_.push_back(axis);
  }
}

}  // namespace crest::certify::curves
