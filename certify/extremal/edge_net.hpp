// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bezier nets along an edge of the grid, over doubles or exactly; a node is the first control. All
// values are 216 times too large. Errors of doubles: at most 2^-48 A as in nets.hpp, and 3 u A more
// for each time an edge is halved, so after 28 times less than 2^-46 A.
#include "certify/extremal/bounds.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::extremal {

template <class Number>
struct EdgeNet {
  using Controls = std::array<Number, 4>;
  std::array<Controls, 6> t;  ///< xx yy zz xy yz xz, world units
  std::array<Controls, 3> v;  ///< grad s
  std::array<Controls, 6> h;  ///< Hess s
  // Sizes A (bounds.hpp).
  double t_size, v_size, h_size;
};

/// Requires: the edge's low end is a node; the high end need not be one if only the first control
/// is read.
template <class Number>
EdgeNet<Number> edge_net(const Fields& fields, u32 node, unsigned axis);
/// The same along x, of which the first control alone may be read: sizes are of what that is made
/// from.
template <class Number>
EdgeNet<Number> node_net(const Fields& fields, u32 node);

/// de Casteljau at the middle: the controls of the lower half, of the upper half.
template <class Number>
std::array<std::array<Number, 4>, 2> halve(const std::array<Number, 4>& c) {
  const Number half = 0.5;
  const Number a = (c[0] + c[1]) * half, m = (c[1] + c[2]) * half, b = (c[2] + c[3]) * half;
  const Number am = (a + m) * half, mb = (m + b) * half, middle = (am + mb) * half;
  return {{{c[0], a, am, middle}, {middle, mb, b, c[3]}}};
}
template <class Number>
EdgeNet<Number> half(const EdgeNet<Number>& net, unsigned which) {
  EdgeNet<Number> out = net;
  for (auto& c : out.t) c = halve(c)[which];
  for (auto& c : out.v) c = halve(c)[which];
  for (auto& c : out.h) c = halve(c)[which];
  return out;
}

template <size_t n, class Number>
Matrices<n> doubles(const std::array<std::array<Number, 4>, 6>& m, double size) {
  Matrices<n> out;
  for (size_t c = 0; c < 6; ++c)
    for (size_t i = 0; i < n; ++i) out.at[c][i] = m[c][i];
  out.size = size;
  return out;
}
template <size_t n, class Number>
Vectors<n> doubles(const std::array<std::array<Number, 4>, 3>& m, double size) {
  Vectors<n> out;
  for (size_t c = 0; c < 3; ++c)
    for (size_t i = 0; i < n; ++i) out.at[c][i] = m[c][i];
  out.size = size;
  return out;
}

}  // namespace crest::certify::extremal
