// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The quadratic spline of a volume by the repeated averages of the paper, in rationals: nothing of
// the checker is used.
#include <cstring>
#include <functional>
#include <map>

#include "certify/exact/spline_volume.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::tests {

using certify::SplineVolume;
using kernel::Rational;
using Exact3 = std::array<Rational, 3>;
using Int3 = std::array<int, 3>;

/// One of the 24 tetrahedra of a cube: vertices C, A, B, D from the cube's centre.
struct ReferenceTet {
  std::array<Int3, 4> vertices;
  std::array<Exact3, 3> rows;  ///< of the barycentrics of A, B, D
  /// Where a point (from the centre) lies: not negative inside.
  std::array<Rational, 4> barycentrics(const Exact3& d) const;
};
const std::array<ReferenceTet, 24>& reference_tets();

class ReferenceSpline {
 public:
  explicit ReferenceSpline(const SplineVolume& volume) : volume_(volume) {}

  int cubes(std::size_t axis) const { return static_cast<int>(volume_.cubes(axis)); }
  /// With linear extrapolation beyond the grid.
  Rational sample(Int3 node) const;
  /// At half of p, from the centre of a cube (p: the sum of two vertices of a tetrahedron).
  Rational coefficient(const Int3& cube, const Int3& p) const;
  /// Coefficients of all products of two vertices.
  const std::array<std::array<Rational, 4>, 4>& form(const Int3& cube, std::size_t tet) const;
  /// The polynomial of a tetrahedron at any point, in lattice coordinates (a cube's side is 2).
  Rational polynomial(const Int3& cube, std::size_t tet, const Exact3& x) const;

 private:
  Rational edge(const Int3& cube, const Int3& p) const;
  Rational average(const Int3& cube, const Int3& p) const;

  const SplineVolume& volume_;
  using Matrix = std::array<std::array<Rational, 4>, 4>;
  mutable std::map<std::pair<Int3, Int3>, Rational> known_;
  mutable std::map<std::pair<Int3, std::size_t>, Matrix> forms_;
};

/// Samples of type f64 on a grid at the origin with unit spacing.
SplineVolume sampled_volume(const std::array<std::uint32_t, 3>& nodes, double level,
                            const std::function<double(double, double, double)>& f,
                            bool extended = false);

/// The least double for which a condition that stays true holds, between two that are not negative;
/// `high` must be one.
double least_double(double low, double high, const std::function<bool(double)>& holds);

}  // namespace crest::tests
