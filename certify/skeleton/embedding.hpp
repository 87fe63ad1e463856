// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The triangles, dead ones included, overlap nowhere (SPEC.md, step 1).
#include "certify/skeleton/domain.hpp"

namespace crest::certify::skeleton {

/// Throws Reject unless boundary sides meet at common vertices only and every chain of them has
/// winding number 1 at its left, 0 at its right. Requires: build_domain has accepted the surface.
/// Cost: pairs of boundary sides that overlap in x, chains times boundary sides; above 2^30
/// refused.
void check_embedding(const Field& field, const Domain& domain, SignLadder& sign);

}  // namespace crest::certify::skeleton
