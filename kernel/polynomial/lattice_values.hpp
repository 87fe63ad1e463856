// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Nets from values at lattice points, by the inverse of the matrix of Bernstein polynomials there.
//
// Lattice points have the basis's indices: on a simplex barycentric coordinates a / Degree, on a
// box x_k = a_k / N_k. Laws. (1) The net has the values given. (2) Polynomials of the basis are
// reproduced.
#include <vector>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/polynomial/bernstein_form.hpp"

namespace crest::kernel {

/// numerators[i count + j] / denominator: what value j adds to coefficient i. All are integers
/// below 2^53 (degree at most 8 on a segment, 6 on simplices; checked when made).
struct LatticeInverse {
  std::vector<double> numerators;
  double denominator = 1;
};
/// The inverse of a square matrix given by rows. Requires: regular.
LatticeInverse inverse_of(const std::vector<Rational>& matrix, std::size_t count);

/// Computed once a basis.
template <int Dim, int Degree>
const LatticeInverse& simplex_inverse() {
  using B = SimplexBasis<Dim, Degree>;
  static const LatticeInverse inverse = [] {
    std::vector<Rational> m(B::count * B::count);
    for (std::size_t i = 0; i < B::count; ++i)
      for (std::size_t j = 0; j < B::count; ++j) {
        Rational x(B::weights[j]);
        for (std::size_t k = 0; k < B::corners; ++k)
          for (int power = 0; power < B::indices[j][k]; ++power)
            x *= Rational(B::indices[i][k], Degree);
        m[i * B::count + j] = x;
      }
    return inverse_of(m, B::count);
  }();
  return inverse;
}

template <class T, int Dim, int Degree>
SimplexNet<T, Dim, Degree> simplex_net_from_values(
    const std::array<T, SimplexBasis<Dim, Degree>::count>& values) {
  static_assert(Degree >= 1);
  const LatticeInverse& inverse = simplex_inverse<Dim, Degree>();
  SimplexNet<T, Dim, Degree> r;
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < count; ++i) {
    T sum = T(inverse.numerators[i * count]) * values[0];
    for (std::size_t j = 1; j < count; ++j)
      sum = sum + T(inverse.numerators[i * count + j]) * values[j];
    r.c[i] = sum / T(inverse.denominator);
  }
  return r;
}

/// Axis by axis, each with a segment's matrix.
template <class T, int... N>
BoxNet<T, N...> box_net_from_values(const std::array<T, BoxBasis<N...>::count>& values) {
  using B = BoxBasis<N...>;
  BoxNet<T, N...> r{values};
  std::size_t axis = 0;
  const auto along = [&](const LatticeInverse& inverse) {
    const std::size_t stride = B::stride(axis), points = B::degrees[axis] + 1;
    for (std::size_t first = 0; first < B::count; ++first) {
      if (B::indices[first][axis] != 0) continue;
      std::vector<T> line;
      for (std::size_t i = 0; i < points; ++i) {
        T sum = T(inverse.numerators[i * points]) * r.c[first];
        for (std::size_t j = 1; j < points; ++j)
          sum = sum + T(inverse.numerators[i * points + j]) * r.c[first + j * stride];
        line.push_back(sum / T(inverse.denominator));
      }
      for (std::size_t i = 0; i < points; ++i) r.c[first + i * stride] = line[i];
    }
    ++axis;
  };
  (along(simplex_inverse<1, N>()), ...);
  return r;
}

}  // namespace crest::kernel
