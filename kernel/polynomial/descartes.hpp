// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Isolation of the real roots in the open unit interval by Descartes' rule in Bernstein form: the
// number of roots, with multiplicities, is the number of sign changes of the coefficients less an
// even number; so no change means none, one change one simple root. Intervals that have more are
// halved (de Casteljau).
//
// Laws. (1) Places are disjoint and increase; each holds exactly one root, every root of the open
// interval lies in one. (2) An open place has a simple root, no root at its ends, and different
// signs there. (3) Places of triage hold the same roots as those of the exact stage, all simple.
// (4) The reversed coefficients have the mirrored places.
#include <optional>
#include <span>
#include <vector>

#include "kernel/polynomial/dyadic.hpp"

namespace crest::kernel {

/// position / 2^depth, or the open interval from there to (position + 1) / 2^depth.
struct UnitPlace {
  Integer position;
  long depth = 0;
  bool point = false;
  Dyadic low() const { return {position, -depth}; }
  Dyadic high() const { return {point ? position : position + 1, -depth}; }
};

/// The same by doubles: low == high never happens.
struct UnitRange {
  double low, high;
};

/// Places of all roots, all simple, or nothing: not decided (a multiple root, a root at an end or
/// at a place where an interval is halved, roots close to each other, a degree above 16). b:
/// Bernstein coefficients, each within `error` of the exact one.
std::optional<std::vector<UnitRange>> triage_unit_places(std::span<const double> b, double error);

/// Places of all roots. Requires: Bernstein coefficients of a polynomial (not zero) without
/// multiple roots in [0, 1], times any positive number. Memory: at most n + 1 intervals are kept at
/// once, n the degree; their coefficients grow by n bits a level.
std::vector<UnitPlace> exact_unit_places(std::vector<Integer> b);

}  // namespace crest::kernel
