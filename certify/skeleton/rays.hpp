// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which separatrix of its zero or switch point a listed line is: none is missing, none twice.
#include "certify/skeleton/straight.hpp"

namespace crest::certify::skeleton {

/// At two points of a side, by their distances from its tail. Throws Reject unless it lies across
/// from the zero in a triangle.
RaySigns ray_signs(const Context& context, u32 side, const Component& zero, const Rational& left,
                   const Rational& right);

/// The name of a line among those of its origin: a ray of a vertex or edge, or the side (root 0)
/// or vertex (root 3, a fan) through which a saddle's ray leaves its triangle.
Ray ray_name(const Context& context, const SkeletonLeg& leg, const Component& zero,
             const RaySigns& signs, bool backward);
Ray ray_name(const Context& context, const StraightWalk& walk, const Component& zero,
             bool backward);

/// What a line claims of its origin: known iff it has legs. A straight line of a zero without an
/// index has no name: an exit of kNone.
struct Claimed {
  SkeletonOrigin origin;
  u32 from;
  bool backward, known;
  Ray ray;
};

/// Throws Reject unless the lines are all separatrices of saddles, inside switch points and inner
/// zeros on vertices and edges, each once; and no lines of other zeros or switch points off the
/// boundary. There may be lines of vertices.
void check_completeness(const Context& context, std::vector<Claimed> lines);

}  // namespace crest::certify::skeleton
