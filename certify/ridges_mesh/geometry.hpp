// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Step 1: what the positions and Monge data must meet; what of them is counted in step 3.
#include "certify/exact/sign_ladder.hpp"
#include "certify/ridges_mesh/records.hpp"
#include "certify/surface/mesh_checks.hpp"

namespace crest::certify {

/// Requires: the faces are a manifold. Throws Reject for a face of zero area, zero d1 or n, k1 <
/// k2.
void check_geometry(const MeshData& data, SignLadder& sign);

/// Vertices whose frames are not what the paper's are (step 3).
struct FrameCounts {
  std::uint32_t against_faces = 0, equal_curvatures = 0, parallel_frames = 0;
};
/// Cost: linear; 50 ns a face unless n is nearly tangential.
FrameCounts count_frames(const MeshData& data, const Topology& topology, SignLadder& sign);

}  // namespace crest::certify
