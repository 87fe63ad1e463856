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

/// A number as a sum of doubles, rounded to `bits` binary digits.
template <class Real>
Expansion expand(Real x, int bits) {
  Expansion sum;
  int last = 0;  // the exponent of the last digit
  while (x != 0) {
    double next = static_cast<double>(x);
    if (next == 0 || !std::isfinite(next)) break;
    if (sum.empty()) last = std::ilogb(next) - bits + 1;
    if (std::ilogb(next) - 52 < last)
      next = std::ldexp(std::nearbyint(std::ldexp(next, -last)), last);
    if (next == 0) break;
    sum.push_back(next);
    x -= next;
    if (std::ilogb(next) - 52 <= last) break;
  }
  if (sum.empty()) sum.push_back(0);
  return sum;
}

/// The number that a sum of doubles is, if Real holds it.
template <class Real>
Real sum_of(const Expansion& x) {
  Real sum = 0;
  for (std::size_t i = x.size(); i-- > 0;) sum += x[i];
  return sum;
}

/// The first cell's result, with what the certificate says of the start in `trace`; open if the
/// precision does not suffice. trap: an ellipse in the triangle of the start or none.
template <class Real>
CellResult<Real> begin(BarrierMaker<Real>& maker, const Start& start, Trace& trace,
                       const TrapShape* trap);

}  // namespace crest::vector_fields
