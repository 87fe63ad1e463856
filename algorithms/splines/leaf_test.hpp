// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Is a leaf of the bisection empty or simple (isosurface.hpp): doubles with one bound, then
// rationals.
#include "algorithms/splines/bisection.hpp"

namespace crest::splines {

/// The net of a leaf less c, over its corners, with a bound of its coefficients' errors.
struct LeafNet {
  std::array<double, 10> b;
  double error, largest;
  bool exact_products = false;  ///< what the test computes in doubles is not rounded at all
};

class LeafTest {
 public:
  LeafTest(const QuadraticSpline& spline, double c);

  /// Of a cube that holds leaves: its coefficients, not less c.
  CubeCoefficients<double> coefficients(const Cube& cube) const {
    return cube_coefficients(spline_.stencil<double>(cube));
  }
  LeafNet net(const CubeCoefficients<double>& a, const Cube& cube, std::size_t tetrahedron,
              const FineCorners* corners) const;

  /// The coefficient of two corners.
  static double at(const LeafNet& net, std::size_t i, std::size_t k);
  bool empty(const LeafNet& net) const;
  /// Empty or simple. `corners` of the leaf, in rationals or doubles.
  bool settled(const LeafNet& net, const Cube& cube, std::size_t tetrahedron,
               const FineCorners& corners) const;
  /// s < c at a corner.
  bool below(const LeafNet& net, const Cube& cube, std::size_t tetrahedron,
             const FineCorners& corners, std::size_t corner) const;
  /// s = c at a corner.
  bool on_level(const LeafNet& net, const Cube& cube, std::size_t tetrahedron,
                const FineCorners& corners, std::size_t corner) const;

 private:
  const QuadraticSpline& spline_;
  double level_;
  int bits_ = 0;  ///< of coefficients less c, all multiples of one step; 0: not known
};

}  // namespace crest::splines
