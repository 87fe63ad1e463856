// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Quadratic super splines of gridded samples (paper 001, section 8.3): every coefficient is a mean
// of samples around its cube with dyadic weights. The spline is C1 across all grid planes; within a
// cube its gradient jumps where only words with the letter C fail (gradient_jump).
#include <span>
#include <vector>

#include "algorithms/splines/lattice_frame.hpp"
#include "algorithms/splines/partition.hpp"
#include "algorithms/splines/value_and_gradient.hpp"

namespace crest::splines {

/// A cube, by its place along each axis.
using Cube = std::array<int, 3>;
/// What lies beyond the outermost samples: no cubes, or a layer of samples by linear extrapolation.
enum class Border : std::uint8_t { none, extend };

/// The samples at a cube and its 26 neighbours, the first axis the fastest.
template <class T>
using Stencil = std::array<T, 27>;
/// A cube's 65 coefficients at the sums of two letters from its lowest corner, 0 to 4 along each
/// axis: a[x + 5 y + 25 z]. The other places are not used.
template <class T>
using CubeCoefficients = std::array<T, 125>;
template <class T>
using QuadraticNet = kernel::SimplexNet<T, 3, 2>;

/// Where tetrahedron t has its ten coefficients in a cube's.
inline constexpr auto kSlots = [] {
  std::array<std::array<std::uint8_t, 10>, kTetrahedra> slots{};
  for (std::size_t t = 0; t < kTetrahedra; ++t)
    for (std::size_t i = 0; i < 10; ++i) {
      const Lattice& p = kDomainPoints<2>[t][i];
      slots[t][i] = static_cast<std::uint8_t>(62 + p[0] + 5 * p[1] + 25 * p[2]);
    }
  return slots;
}();

/// Equations 8.1 to 8.5, as means of means: a_e, a_v of samples, a_m and a_d of these, a_c from
/// conditions of smoothness, a_g and the centre as means of a_c.
/// Cost: 66 products with powers of two, as many sums as the paper's 121 or fewer.
template <class T>
CubeCoefficients<T> cube_coefficients(const Stencil<T>& f) {
  CubeCoefficients<T> a;
  const T half(0.5), quarter(0.25);
  const auto at = [](int x, int y, int z) { return static_cast<std::size_t>(x + 5 * y + 25 * z); };
  // Sums of samples over {s, s + 1} along two axes, the third in the middle.
  std::array<std::array<std::array<T, 2>, 2>, 3> edge;
  constexpr std::array<std::size_t, 3> step = {1, 3, 9};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = step[axis == 0 ? 1 : 0], v = step[axis == 2 ? 1 : 2];
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t s = step[axis] + i * u + k * v;
        edge[axis][i][k] = quarter * ((f[s] + f[s + u]) + (f[s + v] + f[s + u + v]));
      }
  }
  T centre(0);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t x = i & 1, y = i >> 1 & 1, z = i >> 2;
    const int cx = static_cast<int>(4 * x), cy = static_cast<int>(4 * y),
              cz = static_cast<int>(4 * z);
    const T &ex = edge[0][y][z], &ey = edge[1][x][z], &ez = edge[2][x][y];
    // a_v is the mean of a_e on both sides along any axis; here that of all eight samples.
    T sum(0);
    for (const std::size_t s : {0, 1, 3, 4, 9, 10, 12, 13}) sum = sum + f[x + 3 * y + 9 * z + s];
    const T vertex = T(0.125) * sum;
    a[at(cx, cy, cz)] = vertex;
    a[at(2, cy, cz)] = ex;
    a[at(cx, 2, cz)] = ey;
    a[at(cx, cy, 2)] = ez;
    const int mx = 1 + static_cast<int>(2 * x), my = 1 + static_cast<int>(2 * y),
              mz = 1 + static_cast<int>(2 * z);
    a[at(mx, my, cz)] = half * (ex + ey);
    a[at(mx, cy, mz)] = half * (ex + ez);
    a[at(cx, my, mz)] = half * (ey + ez);
    const T inner = half * ((ex + ey) + (ez - vertex));
    a[at(mx, my, mz)] = inner;
    centre = centre + inner;
  }
  for (const int c : {0, 4}) {
    a[at(2, 2, c)] = half * (a[at(1, 1, c)] + a[at(3, 3, c)]);
    a[at(2, c, 2)] = half * (a[at(1, c, 1)] + a[at(3, c, 3)]);
    a[at(c, 2, 2)] = half * (a[at(c, 1, 1)] + a[at(c, 3, 3)]);
    const int g = c == 0 ? 1 : 3;
    a[at(2, 2, g)] =
        quarter * ((a[at(1, 1, g)] + a[at(3, 1, g)]) + (a[at(1, 3, g)] + a[at(3, 3, g)]));
    a[at(2, g, 2)] =
        quarter * ((a[at(1, g, 1)] + a[at(3, g, 1)]) + (a[at(1, g, 3)] + a[at(3, g, 3)]));
    a[at(g, 2, 2)] =
        quarter * ((a[at(g, 1, 1)] + a[at(g, 3, 1)]) + (a[at(g, 1, 3)] + a[at(g, 3, 3)]));
  }
  a[at(2, 2, 2)] = T(0.125) * centre;
  return a;
}

template <class T>
QuadraticNet<T> tetrahedron_net(const CubeCoefficients<T>& a, std::size_t t) {
  QuadraticNet<T> net;
  for (std::size_t i = 0; i < 10; ++i) net.c[i] = a[kSlots[t][i]];
  return net;
}

class QuadraticSpline {
 public:
  /// Requires: finite samples. Throws: kernel::InputError where there is no cube, or the axes lie
  /// in a plane. Cost: none; the spline is its samples.
  QuadraticSpline(kernel::SampledGrid grid, Border border = Border::none);

  const kernel::SampledGrid& grid() const { return grid_; }
  const LatticeFrame& frame() const { return frame_; }
  Border border() const { return border_; }
  const Cube& cubes() const { return cubes_; }
  std::size_t cube_count() const;
  /// Whether doubles hold all coefficients, and all that they are made from, without rounding.
  bool exact() const { return exact_; }
  double largest_sample() const { return largest_; }  ///< by magnitude, extended ones included
  /// All coefficients are multiples of this power of two and below 2^bits() times it. Requires:
  /// exact().
  double step() const { return step_; }
  int bits() const { return bits_; }

  /// The 27 samples around a cube; extended ones are rounded in T.
  template <class T>
  Stencil<T> stencil(const Cube& cube) const;
  /// The cube of a lattice point: of that moved by (e, e^2, e^3), but at upper borders the last.
  Cube cube_at(const Vec3& lattice) const;

  ValueAndGradient evaluate(const Vec3& p) const;
  /// At many points, by threads.
  std::vector<ValueAndGradient> evaluate(std::span<const Vec3> points) const;

 private:
  void evaluate(std::span<const Vec3> points, std::span<ValueAndGradient> values) const;

  kernel::SampledGrid grid_;
  Border border_;
  LatticeFrame frame_;
  Cube cubes_{};
  bool exact_ = false;
  double largest_ = 0, step_ = 1;
  int bits_ = 0;
};

struct SplineSummary {
  double low = 0, high = 0;  ///< hull of all coefficients
  double gradient_jump = 0;  ///< the largest within a cube, rounded up; in units of the world
  Vec3 where{};              ///< the centre of its cube
};
/// Cost: 60 ns a cube.
SplineSummary summarise(const QuadraticSpline& spline);

}  // namespace crest::splines
