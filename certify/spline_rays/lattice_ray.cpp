// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/lattice_ray.hpp"

#include <cmath>

namespace crest::certify::spline_rays {
namespace {

using kernel::Interval;
using kernel::Rational;
using kernel::Sign;

template <class Number>
LatticeFrame<Number> make_frame(const SplineVolume& volume) {
  const auto m = world_matrix<Number>(volume);
  const Number det = determinant(m);
  LatticeFrame<Number> frame;
  for (std::size_t r = 0; r < 3; ++r) {
    frame.origin[r] = Number(volume.origin[r]);
    for (std::size_t k = 0; k < 3; ++k) frame.matrix[r][k] = Number(2) * cofactor(m, k, r) / det;
  }
  frame.shift = volume.extended ? 1 : -1;
  return frame;
}

/// Where the line is at a parameter.
template <class Number>
Number value_on(const Line<Number>& line, const Parameter& a) {
  if (a.form == kForms) return Number(a.number);
  return (Number(static_cast<double>(a.plane)) - form(a.form, line.o)) / form(a.form, line.d);
}
template <class Number>
std::array<Number, 3> point_on(const Line<Number>& line, const Parameter& a) {
  const Number t = value_on(line, a);
  std::array<Number, 3> x;
  for (std::size_t d = 0; d < 3; ++d) x[d] = line.o[d] + line.d[d] * t;
  return x;
}

}  // namespace

LatticeFrame<Rational> exact_frame(const SplineVolume& volume) {
  return make_frame<Rational>(volume);
}
LatticeFrame<Interval> frame_enclosure(const SplineVolume& volume) {
  return make_frame<Interval>(volume);
}

LatticeFrame<LongBall> fine_frame(const LatticeFrame<Rational>& exact) {
  LatticeFrame<LongBall> frame;
  for (std::size_t r = 0; r < 3; ++r) {
    frame.origin[r] = LongBall(exact.origin[r]);
    for (std::size_t k = 0; k < 3; ++k) frame.matrix[r][k] = LongBall(exact.matrix[r][k]);
  }
  frame.shift = exact.shift;
  return frame;
}

LatticeRay::LatticeRay(const LatticeFrame<Interval>& near, const LatticeFrame<LongBall>& fine,
                       const LatticeFrame<Rational>& exact, const std::array<double, 6>& ray)
    : fine_frame_(fine), frame_(exact), ray_(ray), near_(lattice_line(near, ray)) {
  for (std::size_t i = 0; i < kForms; ++i) {
    const auto sign = certain_sign(form(i, near_.d));
    directions_[i] = sign ? *sign : kernel::sign_of(form(i, exact_line().d));
  }
}

const Line<Rational>& LatticeRay::exact_line() const {
  if (!exact_) exact_ = lattice_line(frame_, ray_);
  return *exact_;
}

Parameter LatticeRay::crossing(std::size_t number, std::int64_t plane) const {
  const Interval value =
      (Interval(static_cast<double>(plane)) - form(number, near_.o)) / form(number, near_.d);
  return {number, plane, 0, value};
}

Sign LatticeRay::start(std::size_t number, std::int64_t plane) const {
  const auto k = static_cast<double>(plane);
  if (const auto sign = certain_sign(form(number, near_.o) - k)) return *sign;
  return kernel::sign_of(form(number, exact_line().o) - Rational(k));
}

Rational LatticeRay::exact_value(const Parameter& a) const {
  return value_on(exact_line(), a);
}

Sign LatticeRay::compare(const Parameter& a, const Parameter& b) const {
  if (const auto sign = certain_sign(a.value - b.value)) return *sign;
  return kernel::sign_of(exact_value(a) - exact_value(b));
}

LatticeRay::Floor LatticeRay::half_floor(std::size_t axis, const Parameter& a) const {
  const Interval half = near(a)[axis] * Interval(0.5);
  if (is_defined(half) && std::fabs(half.inf()) < 0x1p40 && std::fabs(half.sup()) < 0x1p40) {
    const auto low = static_cast<std::int64_t>(std::floor(half.inf()));
    const auto high = static_cast<std::int64_t>(std::floor(half.sup()));
    const bool point = half.inf() == half.sup();
    if (low == high && (point || static_cast<double>(low) < half.inf()))
      return {low, point && static_cast<double>(low) == half.inf()};
  }
  const Rational exact_half = exact(a)[axis] / 2;
  auto quotient = numerator(exact_half) / denominator(exact_half);  // towards 0
  const bool equal = denominator(exact_half) == 1;
  if (exact_half < 0 && !equal) --quotient;
  return {static_cast<std::int64_t>(quotient), equal};
}

std::array<Interval, 3> LatticeRay::near(const Parameter& a) const {
  std::array<Interval, 3> x;
  for (std::size_t d = 0; d < 3; ++d)
    x[d] = a.form == d ? Interval(static_cast<double>(a.plane)) : near_.o[d] + near_.d[d] * a.value;
  return x;
}

std::array<LongBall, 3> LatticeRay::fine(const Parameter& a) const {
  if (!fine_) fine_ = lattice_line(fine_frame_, ray_);
  return point_on(*fine_, a);
}

std::array<Rational, 3> LatticeRay::exact(const Parameter& a) const {
  return point_on(exact_line(), a);
}

}  // namespace crest::certify::spline_rays
