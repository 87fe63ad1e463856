// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Step 1: what the positions and Monge data must meet.
#include "certify/exact/sign_ladder.hpp"
#include "certify/ridges_mesh/records.hpp"

namespace crest::certify {

/// Requires: the faces are a manifold. Throws Reject for a face of zero area, zero d1 or n, k1 <
/// k2.
void check_geometry(const MeshData& data, SignLadder& sign);

}  // namespace crest::certify
