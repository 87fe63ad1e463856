// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The field around a zero at a vertex or on an edge: rays that are stream lines, and the sectors
// between them. In each cone of the fan the field is linear and vanishes at the apex.
//
// A ray d is a stream line iff det(d, v(d)) = 0, a quadratic in each cone; out or in by the sign of
// d . v. Between neighbouring rays the sector is parabolic if both are out or both in; else
// hyperbolic if the flow turns towards the out-ray, elliptic if it turns away from it. Exact, in
// rationals.
#include "algorithms/vector_fields/domain.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"
#include "algorithms/vector_fields/zeros.hpp"

namespace crest::vector_fields {

/// A ray in the cone that starts at a half-edge (of a zero vertex: leaving it).
struct Ray {
  std::size_t cone = 0;
  bool on_edge = false;  ///< along the cone's first edge
  double ratio = 0;      ///< second over first coefficient, inside a cone
  bool out = false;
  bool separatrix = false;  ///< forward if out, else backward
  /// The side across from the zero that the ray meets, of a ray inside a cone.
  HalfEdge side = kNone;
  /// Its direction, if two doubles hold it exactly.
  std::optional<Vec2> direction = {};
  HalfEdge edge = kNone;  ///< on an edge, at a vertex: a half-edge of the fan that leaves it
};

struct FanPortrait {
  bool closed = true;
  std::vector<Ray> rays;  ///< counter-clockwise
  Sectors sectors;
  /// Of fans without rays: the sign of every cone's trace, 0 if they differ.
  int growth = 0;
};

/// Of a component that is one vertex or one place on an edge.
FanPortrait examine_fan(const Domain& domain, const ZeroComponent& zero);

/// Sets kind and sectors of components at vertices and on edges.
void classify_fans(const Domain& domain, std::vector<ZeroComponent>& zeros,
                   std::vector<FanPortrait>& portraits);

}  // namespace crest::vector_fields
