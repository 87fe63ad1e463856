// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The components of the zero set, their classes, indices and sectors (SPEC.md, step 2).
#include "certify/skeleton/domain.hpp"

namespace crest::certify::skeleton {

/// A ray that bounds a hyperbolic sector of a vertex or edge zero. It leaves the zero's triangle
/// through the open side `exit` as root 0 or 1 (counter-clockwise) of det(x - z, v(x)), or it runs
/// along the edge to the tail of `exit` (root 2).
struct Ray {
  u32 exit;
  u8 root;
  bool out;
  friend auto operator<=>(const Ray&, const Ray&) = default;
};

struct Component {
  SkeletonZero stated;
  bool on_boundary = false;
  u32 place = kNone;      ///< vertex: the fan; edge: the lesser side; of others kNone
  std::vector<Ray> rays;  ///< vertex, edge with an index
};

struct ZeroSet {
  std::vector<Component> components;  ///< ascending by first triangle
  Buffer<u32> of_triangle;            ///< F: the component that the closed triangle meets, or kNone
};

/// Computes all of it. Cost: linear, plus rationals at zeros on vertices and edges.
ZeroSet find_zeros(const Field& field, const Domain& domain, SignLadder& sign);

/// Whether the field of a side's ends is opposite: a zero inside.
bool has_edge_zero(const Field& field, u32 side, SignLadder& sign);

/// Hyperbolic and elliptic sectors, and the rays, of an inner zero on a vertex or edge.
void count_sectors(const Field& field, const Domain& domain, Component& component);

/// The zero's place exactly: on a vertex or edge, or inside a triangle.
Plane<Rational> zero_point(const Field& field, const Domain& domain, const Component& component);

}  // namespace crest::certify::skeleton
