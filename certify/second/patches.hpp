// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Patches" (theorem 10; condition 1 is in faces.hpp, 6 in graph.hpp), "A patch's" witness
// and "Enclosures along rays".
#include "certify/second/boxes.hpp"

namespace crest::recheck {

/// Proves conditions 2 to 5 of every patch, and the numbers of branches that the claim states of
/// it.
void check_patches(const Problem& problem);

/// The branches of a colour: the intervals of t once around, as they are recorded.
struct RayInterval {
  bool free;
  int sign;    ///< of E_j, or running, of dE_j / dt
  int change;  ///< of the frame from this interval to the next
};
/// Throws: Rejected where the conditions of 4 on neighbouring intervals do not hold.
int count_branches(const std::vector<RayInterval>& around);

}  // namespace crest::recheck
