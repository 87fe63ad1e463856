// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Boxes", "Division of a box" and "Completeness, kind 0".
#include "certify/second/faces.hpp"

namespace crest::recheck {

struct Box {
  std::array<Interval, 3> side;
  std::array<Box, 2> halves(Index axis) const;
  /// Halves across the widest side.
  std::vector<Box> children() const;
};
Box box_of(const std::array<double, 6>& bounds);

/// The sign of F on the box: 0 if it is left open.
/// Throws: Undefined if F is not certainly defined on all of it.
int value_sign(const Surface& surface, const Box& box);
/// The sign of d . grad F; throws also where F may not be regular.
int slope_sign(const Surface& surface, const Box& box, const std::array<double, 3>& d);

/// The one sign on all pieces of a recorded division.
/// Throws: Open, Undefined, Rejected.
int divided_sign(Reader& in, const Box& box, const std::function<int(const Box&)>& sign);

/// Proves that every component of S is met, and that none leaves the box.
void check_completeness(const Problem& problem, const std::vector<FaceOutcome>& outcomes);

/// Proves that Phi is injective and that its image is in the box ("One sheet").
void check_sheets(const Problem& problem, const std::vector<FaceOutcome>& outcomes);

}  // namespace crest::recheck
