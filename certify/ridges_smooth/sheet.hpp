// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Kind 0: Phi is one-to-one, and its image is all of S (SPEC.md, "One sheet" and "Completeness").
#include "certify/ridges_smooth/faces.hpp"

namespace crest::certify::smooth {

/// One named face a component, on which Phi is injective and whose y no other face meets.
/// Throws Reject.
void check_one_sheet(const Claim& claim, const std::vector<FaceResult>& faces);

/// What the tree and the graph boxes prove. Throws Reject. Returns the number of leaves.
std::size_t check_completeness(const Claim& claim);

}  // namespace crest::certify::smooth
