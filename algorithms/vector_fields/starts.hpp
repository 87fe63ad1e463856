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

/// A number as an exact sum of doubles.
template <class Real>
Expansion expand(Real x) {
  Expansion sum;
  while (x != 0) {
    sum.push_back(static_cast<double>(x));
    x -= sum.back();
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
