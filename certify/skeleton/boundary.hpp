// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Boundary loops: winding, turning, switch points, regions; the index relation (SPEC.md, step 3).
#include "certify/skeleton/zeros.hpp"

namespace crest::certify::skeleton {

struct Boundary {
  std::vector<SkeletonLoop> loops;
  std::vector<SkeletonSwitch> switches;
  /// 3F, of boundary sides: regions at their tail and their head, kNone where v.N = 0 next to it.
  std::vector<std::array<u32, 2>> regions;
  u32 region_count = 0;
};

/// Throws Reject if a loop without zeros breaks 2 (winding - turning) = inside - outside. Cost:
/// linear.
Boundary find_boundary(const Field& field, const Domain& domain, SignLadder& sign);

/// Winding of v along the border of the triangles that meet no component without an index.
std::int64_t winding_around_rest(const Field& field, const Domain& domain, const ZeroSet& zeros,
                                 SignLadder& sign);

}  // namespace crest::certify::skeleton
