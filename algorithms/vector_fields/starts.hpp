// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where separatrices start, and the first gates of their corridors.
#include "algorithms/vector_fields/corridor.hpp"
#include "algorithms/vector_fields/sectors.hpp"
#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

/// Of all saddles, switch points that touch from inside, and fans with rays; in the order of these.
std::vector<Start> find_starts(const Domain& domain, const std::vector<ZeroComponent>& zeros,
                               const std::vector<FanPortrait>& portraits, const Boundary& boundary);

/// How the line through a vertex where the field is not zero goes on; `kind` none: along an edge.
Start start_at_vertex(const Domain& domain, const Fan& fan, bool forward);

/// The direction of a ray of a saddle inside a triangle, if two doubles hold it exactly.
std::optional<Vec2> exact_direction(const Domain& domain, const Start& ray);

/// A number as a sum of doubles, of at most so many; exactly, if it has no more bits and no double
/// underflows.
template <class Real>
Expansion expand(Real x, std::size_t most = 40) {
  Expansion sum;
  while (x != 0 && sum.size() < most) {
    const double next = static_cast<double>(x);
    if (next == 0 || !std::isfinite(next)) break;
    sum.push_back(next);
    x -= next;
  }
  if (sum.empty()) sum.push_back(0);
  return sum;
}

/// The first cell's result, with what the certificate says of the start in `trace`; open if the
/// precision does not suffice. trap: an ellipse in the triangle of the start or none.
template <class Real>
CellResult<Real> begin(BarrierMaker<Real>& maker, const Start& start, Trace& trace,
                       const Ellipse* trap);

}  // namespace crest::vector_fields
