// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Both fields live on one domain: triangles, boundary and vertices that correspond (SPEC.md, step
// 2).
#include "certify/skeleton/proof.hpp"

namespace crest::certify::compression {

using namespace skeleton;

/// For what the output has, what it is in the input; kNone: nothing.
struct Match {
  const Proof &in, &out;
  std::vector<u32> corner;                ///< of the triangle with the same corners
  std::vector<std::array<u32, 2>> chain;  ///< of boundary sides: the first and the last one
  std::vector<u32> fan;                   ///< all have one
  std::vector<u32> loop;                  ///< all have one
  std::vector<u32> region, switch_point;  ///< after match_boundary
};

/// Requires: prove_surface has accepted both. `vertices`: the output's in the input. Throws Reject
/// unless both have the same boundary, but for vertices on straight parts. Cost: sorting.
Match match_surfaces(const std::vector<u32>& vertices, const Proof& in, const Proof& out,
                     SignLadder& sign);

/// Requires: prove_skeleton has accepted both. Throws Reject unless switch points and regions are
/// the same.
void match_boundary(Match& match);

}  // namespace crest::certify::compression
