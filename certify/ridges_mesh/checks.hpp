// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Steps 5 to 7 of claim 1 (SPEC.md, "What the checker proves, in order").
#include "certify/ridges_mesh/signs.hpp"

namespace crest::certify {

/// What steps 2 to 4 have established.
struct CheckedMesh {
  const MeshData& data;
  const Topology& topology;
  const MeshSigns& signs;
  const std::vector<std::int8_t>& twice_index;  ///< F
};

/// Step 5. Returns the patch of every face, kNone outside. Throws Reject.
std::vector<std::uint32_t> check_patches(const CheckedMesh& mesh,
                                         const std::vector<PatchRecord>& patches, SignLadder& sign);

/// Steps 6 and 7. Requires: every conflict triangle in a patch (check_patches). Throws Reject.
void check_ridges(const CheckedMesh& mesh, const std::vector<std::uint32_t>& patch_of,
                  const std::vector<RidgeRecord>& ridges,
                  const std::array<std::uint32_t, 4>& counts, SignLadder& sign);

}  // namespace crest::certify
