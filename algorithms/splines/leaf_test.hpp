// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Is a leaf of the bisection empty or simple (isosurface.hpp): doubles with one bound, long doubles
// with another, then rationals.
#include "algorithms/splines/bisection.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::splines {

/// Of the coefficient of two corners in a net.
constexpr std::size_t pair_position(std::size_t i, std::size_t k) {
  kernel::SimplexBasis<3, 2>::Index index{};
  ++index[i];
  ++index[k];
  return kernel::SimplexBasis<3, 2>::position(index);
}

/// The net of a leaf less c, over its corners, with a bound of its coefficients' errors.
struct LeafNet {
  std::array<double, 10> b;
  double error, largest;
  bool exact_products = false;  ///< what the test computes in doubles is not rounded at all
};

/// The same in long doubles, for what doubles do not decide, before rationals.
struct FineNet {
  std::array<long double, 10> b;
  double error;
};

/// The coefficients along an edge, times a positive number, with a bound of their errors.
struct AlongEdge {
  double b0, b1, b2, error;
};

/// A bit for each slot of a cube's coefficients.
using SlotBits = std::array<std::uint64_t, 2>;

/// Those whose coefficient is certainly below the level, or certainly is not.
struct CubeSigns {
  SlotBits below{}, other{};
};

inline constexpr auto kSlotBits = [] {
  std::array<SlotBits, kTetrahedra> bits{};
  for (std::size_t t = 0; t < kTetrahedra; ++t)
    for (const std::uint8_t slot : kSlots[t]) bits[t][slot / 64] |= std::uint64_t{1} << slot % 64;
  return bits;
}();

class LeafTest {
 public:
  LeafTest(const QuadraticSpline& spline, double c);

  /// Of a cube that holds leaves: its coefficients, not less c; of samples at the ends of doubles
  /// times a power of two, as are nets: products neither overflow nor vanish.
  CubeCoefficients<double> coefficients(const Cube& cube) const {
    Stencil<double> f = spline_.stencil<double>(cube);
    if (scale_ != 1)
      for (double& x : f) x *= scale_;
    return cube_coefficients(f);
  }
  /// `corners`: of the leaf; null here and below: it is the tetrahedron.
  LeafNet net(const CubeCoefficients<double>& a, const Cube& cube, std::size_t tetrahedron,
              const FineCorners* corners) const;

  CubeSigns signs(const CubeCoefficients<double>& a) const;
  /// Whether a tetrahedron is certainly empty.
  static bool empty(const CubeSigns& signs, std::size_t tetrahedron) {
    const auto holds = [&](const SlotBits& bits) {
      const SlotBits& all = kSlotBits[tetrahedron];
      return (bits[0] & all[0]) == all[0] && (bits[1] & all[1]) == all[1];
    };
    return holds(signs.below) || holds(signs.other);
  }

  bool empty(const LeafNet& net) const;
  /// Empty or simple.
  bool settled(const LeafNet& net, const Cube& cube, std::size_t tetrahedron,
               const FineCorners* corners) const;
  /// The sign of s - c at a corner.
  kernel::Sign sign(const LeafNet& net, const Cube& cube, std::size_t tetrahedron,
                    const FineCorners* corners, std::size_t corner) const;
  /// From a corner below the level to one that is not; by rationals where doubles do not tell that
  /// they are: there a few small samples among large ones may leave them no digit.
  AlongEdge along(const LeafNet& net, const Cube& cube, std::size_t tetrahedron,
                  const FineCorners* corners, std::size_t below, std::size_t other) const;

 private:
  FineNet fine_net(const Cube& cube, std::size_t tetrahedron, const FineCorners* corners) const;

  const QuadraticSpline& spline_;
  double level_;
  double scale_ = 1, scaled_level_;
  double error_;  ///< of a cube's coefficients
  int bits_ = 0;  ///< of coefficients less c, all multiples of one step; 0: not known
};

}  // namespace crest::splines
