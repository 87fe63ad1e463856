// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A triangle seen from one of its corners: x = o + a (next - o) + b (previous - o), and v there.
#include <algorithm>

#include "certify/skeleton/big.hpp"
#include "certify/skeleton/field.hpp"

namespace crest::certify::skeleton {

/// Barycentric coordinates: 0 of o (1 - a - b), 1 of next (a), 2 of previous (b).
template <class Number>
struct Point {
  Number a, b;
};

/// What is multiplied with a curve's derivative (a', b'): first a' + second b'. Linear, by its
/// values at o, next, previous. magnitude: bounds of the terms of these.
template <class Number>
struct LinearForms {
  std::array<Number, 3> first, second;
  double magnitude_first = 0, magnitude_second = 0;
};

template <class Number>
struct Frame {
  u32 corner = kNone;               ///< o
  LinearForms<Number> determinant;  ///< det(x', v)
  LinearForms<Number> product;      ///< x' . v
};

/// Each value of a form is three roundings away from the data (signs.hpp).
template <class Number>
Frame<Number> make_frame(const Field& field, u32 corner, bool backward) {
  const std::array<u32, 3> corners = {corner, next_corner(corner), previous_corner(corner)};
  const auto number = [](double x) { return Number(x); };
  const auto o = lifted(number, field.position(corner));
  const auto e1 = lifted(number, field.position(corners[1])) - o,
             e2 = lifted(number, field.position(corners[2])) - o;
  Frame<Number> f;
  f.corner = corner;
  const auto bounded = [](double& magnitude, const auto& e, double x, double y) {
    if constexpr (!std::is_same_v<Number, Rational>) {
      const double m = std::fabs(to_double(e.x)) * x + std::fabs(to_double(e.y)) * y;
      if (!(m <= magnitude)) magnitude = std::isnan(m) ? HUGE_VAL : m;
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    Pair v = field.vector(corners[k]);
    if (backward) v = {-v[0], -v[1]};
    const auto w = lifted(number, v);
    f.determinant.first[k] = det(e1, w);
    f.determinant.second[k] = det(e2, w);
    f.product.first[k] = dot(e1, w);
    f.product.second[k] = dot(e2, w);
    const double x = std::fabs(v[0]), y = std::fabs(v[1]);
    bounded(f.determinant.magnitude_first, e1, y, x);
    bounded(f.determinant.magnitude_second, e2, y, x);
    bounded(f.product.magnitude_first, e1, x, y);
    bounded(f.product.magnitude_second, e2, x, y);
  }
  return f;
}

}  // namespace crest::certify::skeleton
