// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Patches" (theorem 10; condition 1 is in faces.hpp, 6 in graph.hpp), "A patch's" witness
// and "Enclosures along rays".
#include "certify/second/boxes.hpp"

namespace crest::recheck {

/// Proves conditions 2 to 5 of every patch, and the numbers of branches that the claim states of
/// it.
void check_patches(const Problem& problem);

}  // namespace crest::recheck
