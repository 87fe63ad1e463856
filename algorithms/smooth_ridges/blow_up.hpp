// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ridges at an umbilic, proven by a blow-up (certify/ridges_smooth/SPEC.md, Patches; paper 002,
// section 8.2 names the index and the two kinds).
//
// On the square Q = z + [-R, R]^2 of the coordinates write a point as z* + r e, e on the boundary
// of
// [-1, 1]^2. A vanishes at the umbilic z*, so A = r P with P smooth down to r = 0: the principal
// directions are those of P, and the zeros of E in Q are curves r -> t(r) on the sides' intervals
// of t.
#include <array>
#include <optional>

#include "algorithms/smooth_ridges/forms.hpp"
#include "kernel/arithmetic/interval.hpp"

namespace crest::smooth_ridges {

/// Or may: what is not defined does.
inline bool holds_zero(const kernel::Interval& x) {
  return !(x.inf() > 0 || x.sup() < 0) || !is_defined(x);
}

using IntervalJet1 = kernel::Jet<kernel::Interval, 2, 1>;
using IntervalJet2 = kernel::Jet<kernel::Interval, 2, 2>;

/// Enclosures at the umbilic (`at`: over a small square that holds it) and over all of Q (`over`).
struct UmbilicEnclosures {
  Forms<IntervalJet1> at, over;
  Shape<IntervalJet1> shape_at;
  Shape<IntervalJet2> shape_over;
};

struct Branches {
  int twice_index;
  std::array<int, 2> count;  ///< blue, red: 1 or 3
};

/// What is proven for half-size R, or nothing. Requires: a RoundUpward object alive.
std::optional<Branches> blow_up(const UmbilicEnclosures& enclosures, double radius);

}  // namespace crest::smooth_ridges
