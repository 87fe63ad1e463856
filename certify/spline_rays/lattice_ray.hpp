// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A ray in lattice coordinates, and the parameters at which it crosses planes (SPEC.md, "Walk"):
// intervals, and rationals where these do not decide.
#include <optional>

#include "certify/exact/quadratic_spline.hpp"
#include "certify/spline_rays/long_ball.hpp"

namespace crest::certify::spline_rays {

/// The planes of the partition: x, y, z, x + y, x - y, x + z, x - z, y + z, y - z = even integer.
inline constexpr std::size_t kForms = 9;

template <class Number>
Number form(std::size_t number, const std::array<Number, 3>& x) {
  switch (number) {
    case 0:
    case 1:
    case 2:
      return x[number];
    case 3:
      return x[0] + x[1];
    case 4:
      return x[0] - x[1];
    case 5:
      return x[0] + x[2];
    case 6:
      return x[0] - x[2];
    case 7:
      return x[1] + x[2];
    default:
      return x[1] - x[2];
  }
}

/// World to lattice: X = matrix (p - origin) + shift.
template <class Number>
struct LatticeFrame {
  VolumeMatrix<Number> matrix;
  std::array<Number, 3> origin;
  double shift;
};
/// Requires: the volume's matrix is not singular.
LatticeFrame<kernel::Rational> exact_frame(const SplineVolume& volume);
/// The same, enclosed. Requires: rounding upward.
LatticeFrame<kernel::Interval> frame_enclosure(const SplineVolume& volume);
/// The same, in long doubles.
LatticeFrame<LongBall> fine_frame(const LatticeFrame<kernel::Rational>& exact);

template <class Number>
struct Line {
  std::array<Number, 3> o, d;
};

template <class Number>
Line<Number> lattice_line(const LatticeFrame<Number>& frame, const std::array<double, 6>& ray) {
  Line<Number> line;
  for (std::size_t r = 0; r < 3; ++r) {
    line.o[r] = Number(frame.shift);
    line.d[r] = Number(0);
    for (std::size_t k = 0; k < 3; ++k) {
      line.o[r] = line.o[r] + frame.matrix[r][k] * (Number(ray[k]) - frame.origin[k]);
      line.d[r] = line.d[r] + frame.matrix[r][k] * Number(ray[3 + k]);
    }
  }
  return line;
}

/// A parameter of the ray: a number, or where a form has a value.
struct Parameter {
  std::size_t form = kForms;  ///< kForms: a number
  std::int64_t plane = 0;
  double number = 0;
  kernel::Interval value{0};
};

/// Requires: rounding upward as long as it lives.
class LatticeRay {
 public:
  LatticeRay(const LatticeFrame<kernel::Interval>& near, const LatticeFrame<LongBall>& fine,
             const LatticeFrame<kernel::Rational>& exact, const std::array<double, 6>& ray);

  Parameter at(double number) const { return {kForms, 0, number, kernel::Interval(number)}; }
  /// Requires: direction(form) is not zero.
  Parameter crossing(std::size_t form, std::int64_t plane) const;

  /// The sign of the form's growth along the ray.
  kernel::Sign direction(std::size_t form) const { return directions_[form]; }
  /// The sign of the form's value at parameter 0, less the plane's.
  kernel::Sign start(std::size_t form, std::int64_t plane) const;
  kernel::Sign compare(const Parameter& a, const Parameter& b) const;
  /// The greatest integer not above half of a coordinate at a parameter, and whether it is equal.
  struct Floor {
    std::int64_t value;
    bool equal;
  };
  Floor half_floor(std::size_t axis, const Parameter& a) const;

  /// The point at a parameter.
  std::array<kernel::Interval, 3> near(const Parameter& a) const;
  std::array<LongBall, 3> fine(const Parameter& a) const;
  std::array<kernel::Rational, 3> exact(const Parameter& a) const;

 private:
  const Line<kernel::Rational>& exact_line() const;
  kernel::Rational exact_value(const Parameter& a) const;

  const LatticeFrame<LongBall>& fine_frame_;
  const LatticeFrame<kernel::Rational>& frame_;
  const std::array<double, 6>& ray_;
  Line<kernel::Interval> near_;
  mutable std::optional<Line<LongBall>> fine_;
  mutable std::optional<Line<kernel::Rational>> exact_;
  std::array<kernel::Sign, kForms> directions_;
};

}  // namespace crest::certify::spline_rays
