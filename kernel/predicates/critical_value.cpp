// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/critical_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {
namespace {

// A coordinate of a point inside its edge or face. Comparisons are false for NaN.
Interval within_unit(const Interval& x) {
  return {x.inf() > 0 ? std::min(x.inf(), 1.0) : 0.0, x.sup() < 1 ? std::max(x.sup(), 0.0) : 1.0};
}

struct Coordinates {
  Interval x, y;
};

Coordinates edge_place(const Interval& g, const Interval& p) {
  return {within_unit(g / (Interval(-4.0) * p)), Interval(0.0)};
}

Coordinates face_place(const FaceDerivatives<Interval>& d) {
  const Interval h4 = Interval(4.0) * (d.p * d.r - d.q * d.q);
  return {within_unit((d.h * d.q - d.g * d.r) / h4), within_unit((d.g * d.q - d.h * d.p) / h4)};
}

std::array<Rational, 2> exact_place(const CriticalValue& value) {
  if (value.kind == ValueKind::edge) {
    const auto& f = value.f;
    return {slope<Rational>(f.corner[0], f.corner[1], f.side[0]) /
                (-4 * bend<Rational>(f.corner[0], f.corner[1], f.side[0])),
            Rational(0)};
  }
  const FaceDerivatives<Rational> d(value.f);
  const Rational h4 = 4 * (d.p * d.r - d.q * d.q);
  return {(d.h * d.q - d.g * d.r) / h4, (d.g * d.q - d.h * d.p) / h4};
}

// The conversion truncates towards zero.
ValueRange around(const Rational& x) {
  const double near = x.convert_to<double>(), infinity = std::numeric_limits<double>::infinity();
  if (Rational(near) == x) return {near, near};
  return {std::nextafter(near, -infinity), std::nextafter(near, infinity)};
}

ValueRange exact_range(const CriticalValue& value) {
  const std::array<Rational, 2> x = exact_place(value);
  const FaceDerivatives<Rational> d(value.f);
  return around(Rational(value.f.corner[0]) + (d.g * x[0] + d.h * x[1]) / 2);
}

// The inputs' scale times this is as wide as a range may be.
constexpr double kTight = 0x1p-40;

double scale(const FaceValues& f) {
  double m = 0;
  for (std::size_t k = 0; k < 3; ++k)
    m = std::max({m, std::fabs(f.corner[k]), std::fabs(f.side[k])});
  return m;
}

ValueRange interval_range(const CriticalValue& value) {
  const FaceValues& f = value.f;
  RoundUpward guard;
  Interval v;
  if (value.kind == ValueKind::edge) {
    const Interval g = slope<Interval>(f.corner[0], f.corner[1], f.side[0]);
    const Interval p = bend<Interval>(f.corner[0], f.corner[1], f.side[0]);
    v = Interval(f.corner[0]) + Interval(0.5) * g * edge_place(g, p).x;
  } else {
    const FaceDerivatives<Interval> d(f);
    const Coordinates c = face_place(d);
    v = Interval(f.corner[0]) + Interval(0.5) * (d.g * c.x + d.h * c.y);
  }
  return {v.inf(), v.sup()};
}

}  // namespace

CriticalValue normal_form(const CriticalValue& value) {
  CriticalValue v = value;
  for (std::size_t k = 0; k < 3; ++k) {
    v.f.corner[k] += 0.0;  // +0 for -0
    v.f.side[k] += 0.0;
  }
  const FaceValues f = v.f;
  if (v.kind == ValueKind::edge) v.f = std::min(f, f.mirrored());
  if (v.kind == ValueKind::face)
    for (const FaceValues& g : {f, f.rotated(1), f.rotated(2)})
      v.f = std::min({v.f, g, g.mirrored()});
  return v;
}

ValueRange value_range(const CriticalValue& value) {
  if (value.kind == ValueKind::vertex) return {value.f.corner[0], value.f.corner[0]};
  const ValueRange r = interval_range(value);
  return r.high - r.low <= kTight * scale(value.f) ? r : exact_range(value);
}

std::array<double, 2> critical_place(const CriticalValue& value) {
  if (value.kind == ValueKind::vertex) return {0, 0};
  Coordinates c;
  {
    RoundUpward guard;
    const FaceValues& f = value.f;
    c = value.kind == ValueKind::edge
            ? edge_place(slope<Interval>(f.corner[0], f.corner[1], f.side[0]),
                         bend<Interval>(f.corner[0], f.corner[1], f.side[0]))
            : face_place(FaceDerivatives<Interval>(f));
  }
  if (std::max(c.x.sup() - c.x.inf(), c.y.sup() - c.y.inf()) <= kTight)
    return {c.x.inf() + (c.x.sup() - c.x.inf()) / 2, c.y.inf() + (c.y.sup() - c.y.inf()) / 2};
  const std::array<Rational, 2> x = exact_place(value);
  return {x[0].convert_to<double>(), x[1].convert_to<double>()};
}

}  // namespace crest::kernel
