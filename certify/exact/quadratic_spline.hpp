// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The quadratic super spline of a volume (spline_rays/SPEC.md, "Spline"): samples near a cube over
// any number type, coefficients by masks, blossoms of a tetrahedron's polynomial.
#include <cstring>

#include "certify/exact/spline_volume.hpp"
#include "certify/exact/type6.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify {

/// Weights of the 27 samples round a cube's sample, x fastest, and their sum.
struct SplineMask {
  std::array<std::int8_t, 27> weights{};
  std::uint8_t sum = 0;
};

/// Of the coefficient whose domain point is half of p (from the cube's centre): |p_d| <= 2, the sum
/// of two vertices of one tetrahedron.
const SplineMask& spline_mask(const std::array<int, 3>& p);

template <class Number>
using Neighbourhood = std::array<Number, 27>;

template <class Number>
Number coefficient(const Neighbourhood<Number>& samples, const std::array<int, 3>& p) {
  const SplineMask& mask = spline_mask(p);
  Number sum(0);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (mask.weights[i] != 0) sum = sum + Number(static_cast<double>(mask.weights[i])) * samples[i];
  return sum * Number(1.0 / mask.sum);  // a power of two
}

/// Coefficients of a quadratic polynomial on a tetrahedron: of the product of corners i and j.
template <class Number>
using Quadratic = std::array<std::array<Number, 4>, 4>;

/// `at` gives the coefficient of a domain point.
template <class Number, class Coefficients>
Quadratic<Number> quadratic(const Tetrahedron& tet, Coefficients&& at) {
  const auto v = tet.vertices();
  Quadratic<Number> q;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) {
      q[i][j] = at({v[i][0] + v[j][0], v[i][1] + v[j][1], v[i][2] + v[j][2]});
      q[j][i] = q[i][j];
    }
  return q;
}
template <class Number>
Quadratic<Number> quadratic(const Neighbourhood<Number>& samples, const Tetrahedron& tet) {
  return quadratic<Number>(tet,
                           [&](const std::array<int, 3>& p) { return coefficient(samples, p); });
}

/// The coefficients of a cube, each computed once.
template <class Number>
class CubeCoefficients {
 public:
  explicit CubeCoefficients(const Neighbourhood<Number>& samples) : samples_(samples) {}

  const Number& operator()(const std::array<int, 3>& p) {
    const auto i = static_cast<std::size_t>(p[0] + 2 + 5 * (p[1] + 2) + 25 * (p[2] + 2));
    if (!known_[i]) values_[i] = coefficient(samples_, p);
    known_[i] = true;
    return values_[i];
  }

 private:
  Neighbourhood<Number> samples_;
  std::array<Number, 125> values_;
  std::array<bool, 125> known_{};
};

/// p[x, y] at points given by barycentrics.
template <class Number>
Number blossom(const Quadratic<Number>& q, const std::array<Number, 4>& x,
               const std::array<Number, 4>& y) {
  Number sum(0);
  for (std::size_t i = 0; i < 4; ++i)
    sum = sum + x[i] * (q[i][0] * y[0] + q[i][1] * y[1] + q[i][2] * y[2] + q[i][3] * y[3]);
  return sum;
}

using CubePosition = std::array<std::uint32_t, 3>;

class QuadraticSpline {
 public:
  explicit QuadraticSpline(const SplineVolume& volume) : volume_(volume) {}

  std::uint32_t cubes(std::size_t axis) const { return volume_.cubes(axis); }
  std::size_t cube_count() const { return std::size_t{cubes(0)} * cubes(1) * cubes(2); }
  CubePosition position(std::size_t cube) const {
    const std::size_t row = cube / cubes(0);
    return {static_cast<std::uint32_t>(cube % cubes(0)), static_cast<std::uint32_t>(row % cubes(1)),
            static_cast<std::uint32_t>(row / cubes(1))};
  }

  std::size_t number(const CubePosition& cube) const {
    return cube[0] + std::size_t{cubes(0)} * (cube[1] + std::size_t{cubes(1)} * cube[2]);
  }

  /// The samples round a cube's own, extended ones exactly. Requires for intervals: they are
  /// rounded upward.
  template <class Number>
  Neighbourhood<Number> neighbourhood(const CubePosition& cube) const {
    Neighbourhood<Number> samples;
    std::size_t i = 0;
    std::array<std::int64_t, 3> at{};
    for (at[2] = -1; at[2] <= 1; ++at[2])
      for (at[1] = -1; at[1] <= 1; ++at[1])
        for (at[0] = -1; at[0] <= 1; ++at[0]) {
          std::array<std::int64_t, 3> node{};
          for (std::size_t d = 0; d < 3; ++d)
            node[d] = std::int64_t{cube[d]} + at[d] + (volume_.extended ? 0 : 1);
          samples[i++] = extended<Number>(node, 0);
        }
    return samples;
  }

  /// For every cube, in their order, whether all coefficients are surely above or surely below the
  /// level: then 1. Cost: 50 nanoseconds a cube, on all cores.
  std::vector<std::uint8_t> one_sided() const;

 private:
  /// A sample, its axes from `axis` on extended beyond the grid.
  template <class Number>
  Number extended(std::array<std::int64_t, 3> node, std::size_t axis) const {
    if (axis == 3) return Number(sample(node));
    const std::int64_t last = std::int64_t{volume_.nodes[axis]} - 1;
    if (node[axis] >= 0 && node[axis] <= last) return extended<Number>(node, axis + 1);
    const std::int64_t inner = node[axis] < 0 ? 1 : -1;
    node[axis] += inner;
    const Number first = extended<Number>(node, axis + 1);
    node[axis] += inner;
    return first + first - extended<Number>(node, axis + 1);
  }
  double sample(const std::array<std::int64_t, 3>& node) const;

  struct Range {
    double low, high;
  };
  Range range_round(const CubePosition& cube) const;
  std::vector<Range> column_ranges(const CubePosition& row) const;
  bool surely_one_sided(const Range& range) const;

  const SplineVolume& volume_;
};

}  // namespace crest::certify
