// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Parts of a simplex's Bezier net: both sides of a cut through an edge, faces and edges.
//
// Laws. (1) Values of the parts of a split are values of the whole. (2) A face's net has the values
// on the face. (3) Cutting commutes with restriction to a face that holds the cut edge; a face that
// does not is not changed.
#include "kernel/polynomial/bernstein_form.hpp"

namespace crest::kernel {

/// The two parts of a simplex cut at (1 - t) corner i + t corner j: `near` keeps corner i (the new
/// corner takes j's number), `far` keeps j.
template <class N>
struct SplitNets {
  N near, far;
};
template <class T, int Dim, int Degree>
SplitNets<SimplexNet<T, Dim, Degree>> split(const SimplexNet<T, Dim, Degree>& b, std::size_t i,
                                            std::size_t j, const T& t) {
  using Basis = SimplexBasis<Dim, Degree>;
  SplitNets<SimplexNet<T, Dim, Degree>> r{b, b};
  const T s = T(1) - t;
  for (std::size_t k = 0; k < Basis::count; ++k) {
    // One line of coefficients from corner i's side to j's: those with a_i + a_j fixed.
    typename Basis::Index a = Basis::indices[k];
    if (a[j] != 0) continue;
    const std::size_t length = a[i];
    std::array<std::size_t, Degree + 1> line{};
    for (std::size_t m = 0; m <= length; ++m) {
      line[m] = Basis::position(a);
      if (m == length) break;
      --a[i];
      ++a[j];
    }
    for (std::size_t level = 1; level <= length; ++level) {
      for (std::size_t m = 0; m + level <= length; ++m)
        r.far.c[line[m]] = s * r.far.c[line[m]] + t * r.far.c[line[m + 1]];
      r.near.c[line[level]] = r.far.c[line[0]];
    }
  }
  return r;
}

/// The net on the face (edge, corner) spanned by the given corners, in their order.
template <int FaceDim, class T, int Dim, int Degree>
SimplexNet<T, FaceDim, Degree> restricted(const SimplexNet<T, Dim, Degree>& b,
                                          const std::array<std::size_t, FaceDim + 1>& corners) {
  SimplexNet<T, FaceDim, Degree> r;
  for (std::size_t i = 0; i < r.c.size(); ++i) {
    typename SimplexBasis<Dim, Degree>::Index a{};
    for (std::size_t k = 0; k <= FaceDim; ++k)
      a[corners[k]] = SimplexBasis<FaceDim, Degree>::indices[i][k];
    r.c[i] = b.c[SimplexBasis<Dim, Degree>::position(a)];
  }
  return r;
}

}  // namespace crest::kernel
