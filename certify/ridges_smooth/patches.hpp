// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All patches (SPEC.md, theorem 10), and the graph's counts (theorem 11).
#include "certify/ridges_smooth/faces.hpp"

namespace crest::certify::smooth {

/// Items 1 to 5, and 6 as far as the patch alone is concerned. Throws Reject.
void check_patches(const Claim& claim, const std::vector<FaceResult>& faces);

/// By colour, per edge.
using Crossings = std::array<std::vector<std::uint8_t>, 2>;

/// Item 6: as many crossed edges on each border as branches; then loops and paths. Throws Reject
/// unless the counts are the stated ones. Requires: check_patches, check_edges.
void check_graph(const Claim& claim, const Crossings& crossed);

}  // namespace crest::certify::smooth
