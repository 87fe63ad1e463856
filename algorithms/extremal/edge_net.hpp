// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields on an edge of the grid: cubic nets of four controls, and what they prove.
#include <array>
#include <vector>

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/fields.hpp"

namespace crest::extremal {

using Cubic = std::array<double, 4>;
struct EdgeNet {
  std::array<Cubic, 6> tensor, hessian;  ///< T and Hess s
  std::array<Cubic, 3> gradient;         ///< of s
  // Sizes that roundings are relative to.
  double tensor_size = 0, gradient_size = 0, hessian_size = 0;

  Tensor tensor_at(double t) const;
  Vec3 gradient_at(double t) const;
  /// The net of one half.
  EdgeNet half(bool upper) const;
};

/// Requires: v + axis is a node, too.
EdgeNet edge_net(const Fields& fields, const Node& v, std::size_t axis);

/// Of the cone test on the net; gap <= 0: it fails.
struct EdgeBounds {
  double gap, theta;
};
EdgeBounds edge_bounds(const EdgeNet& net, const Vec3& w);

/// A part of an edge with a vector for which it passes the cone test.
struct Leaf {
  double low, high;
  Short3 w;
};
/// The edge's bisection in preorder, its leaves from the lower end on.
struct Transport {
  std::vector<std::uint8_t> tree;  ///< 0 leaf, 1 split
  std::vector<Leaf> leaves;
  int depth = 0;
  std::size_t tests = 0;
  bool decided = true;
};
/// Proves lambda1 simple along an edge with these directions at its ends; at most 14 bisections.
Transport transport(const EdgeNet& net, const Vec3& lower, const Vec3& upper);

/// +1 or -1 for w that both pass the cone test at one place.
inline int side(const Vec3& a, const Vec3& b) {
  return kernel::dot(a, b) < 0 ? -1 : 1;
}

/// Types of the zeros of g on an edge.
enum class ZeroType : std::uint8_t { merely_critical, extremal, undecided };
ZeroType zero_type(const EdgeNet& net, const std::vector<Leaf>& leaves);

/// A zero of g where its signs at the ends, oriented by the first and the last leaf, differ.
double zero_place(const EdgeNet& net, const std::vector<Leaf>& leaves, int lower, int upper);

}  // namespace crest::extremal
