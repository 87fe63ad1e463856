// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The normal form on one cube (SPEC.md, "Normal form"), over any number type.
//
// Corner k of a cube has bit d set if it lies at the upper end along axis d. The edge along axis a
// at the places b, c along the other two axes is 4 a + b + 2 c. Lengths are in cube sides, the
// centre is the origin.
#include "certify/exact/type6.hpp"
#include "certify/spline_cubic/records.hpp"

namespace crest::certify::spline_cubic {

inline constexpr unsigned bit(unsigned corner, std::size_t axis) {
  return corner >> axis & 1U;
}
/// The edge of a corner along an axis.
inline constexpr std::size_t edge_at(unsigned corner, std::size_t axis) {
  return 4 * axis + bit(corner, kOtherAxes[axis][0]) + 2 * bit(corner, kOtherAxes[axis][1]);
}

template <class Number>
struct CubeForm {
  std::array<Number, 8> f;
  std::array<std::array<Number, 3>, 8> g;
  std::array<std::array<Number, 2>, 12> t;
  Number centre_f;
  std::array<Number, 3> centre_g;
};

/// Place of a cube's lowest vertex, and of its number.
struct CubePlace {
  std::array<std::size_t, 3> at;
  std::size_t number(const std::array<std::uint32_t, 3>& n) const {
    return at[0] + n[0] * (at[1] + n[1] * at[2]);
  }
  std::size_t vertex(const std::array<std::uint32_t, 3>& n, unsigned corner) const {
    return at[0] + bit(corner, 0) +
           (n[0] + std::size_t{1}) *
               (at[1] + bit(corner, 1) + (n[1] + std::size_t{1}) * (at[2] + bit(corner, 2)));
  }
};

/// The numbers of a cube, lifted.
template <class Number, class Lift>
CubeForm<Number> load(const SplineCubicData& data, const CubePlace& place, const Lift& lift) {
  CubeForm<Number> form;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const std::size_t vertex = place.vertex(data.cubes, corner);
    const auto& numbers = data.vertices[vertex];
    form.f[corner] = lift(numbers[0]);
    for (std::size_t d = 0; d < 3; ++d) {
      form.g[corner][d] = lift(numbers[d + 1]);
      if (bit(corner, d) != 0) continue;
      for (std::size_t k = 0; k < 2; ++k)
        form.t[edge_at(corner, d)][k] = lift(data.slopes[vertex][2 * d + k]);
    }
  }
  const auto& centre = data.centres[place.number(data.cubes)];
  form.centre_f = lift(centre[0]);
  for (std::size_t d = 0; d < 3; ++d) form.centre_g[d] = lift(centre[d + 1]);
  return form;
}

template <class Number>
Number twice(const Number& x) {
  return x + x;
}
/// x if the corner is at the lower end, else -x: the way from the corner inwards along the axis.
template <class Number>
Number inwards(const Number& x, unsigned corner, std::size_t axis) {
  return bit(corner, axis) == 0 ? x : Number(-x);
}

/// a(AAB) + a(ABB) of the edge of A along an axis.
template <class Number>
Number edge_sum(const CubeForm<Number>& form, unsigned corner, std::size_t axis) {
  const unsigned other = corner ^ 1U << axis;
  return form.f[corner] + inwards(form.g[corner][axis], corner, axis) + form.f[other] +
         inwards(form.g[other][axis], other, axis);
}

/// 8 r(A), r(A) = a(CCA) - (the sum of a(ABC) over the three edges at A - a(AAC)) / 2. If all
/// numbers are integers of their units below 2^53, no partial sum reaches 544 2^53 u / 8.
template <class Number>
Number eight_residuals(const CubeForm<Number>& form, unsigned corner) {
  Number sum = twice(twice(twice(form.centre_f) + form.f[corner]));
  for (std::size_t d = 0; d < 3; ++d) {
    const Number& g = form.centre_g[d];
    sum = sum - inwards(twice(twice(g)), corner, d) + inwards(twice(form.g[corner][d]), corner, d) -
          twice(edge_sum(form, corner, d));
    for (std::size_t k = 0; k < 2; ++k)
      sum = sum - inwards(twice(form.t[edge_at(corner, d)][k]), corner, kOtherAxes[d][k]);
  }
  return sum;
}

}  // namespace crest::certify::spline_cubic
