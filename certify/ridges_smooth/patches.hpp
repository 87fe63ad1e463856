// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All patches (SPEC.md, theorem 10), and the graph's counts (theorem 11).
#include "certify/ridges_smooth/box.hpp"
#include "certify/ridges_smooth/faces.hpp"

namespace crest::certify::smooth {

/// Kind 0: Q x [m0, m1] of a patch, its sides at m0 and m1, the direction of the height.
struct GraphBox {
  Box all, below, above;
  std::array<double, 3> axis;
};
GraphBox graph_box(const SmoothPatchRecord& patch);

/// Items 1 (kind 0: as far as check_faces does not show it) to 5, and 6 as far as the patch alone
/// is concerned. Throws Reject.
void check_patches(const Claim& claim);

/// By colour, per edge.
using Crossings = std::array<std::vector<std::uint8_t>, 2>;

/// Item 6: as many crossed edges on each border as branches; then loops and paths. Throws Reject
/// unless the counts are the stated ones. Requires: check_patches, check_edges.
void check_graph(const Claim& claim, const Crossings& crossed);

}  // namespace crest::certify::smooth
