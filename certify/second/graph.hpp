// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "The graph" (theorem 11) and condition 6 of patches: all counts of the claim.
#include "certify/second/faces.hpp"

namespace crest::recheck {

/// Throws: Rejected for a count that is another.
void check_graph(const Problem& problem, const std::array<std::vector<bool>, 2>& crossed);

}  // namespace crest::recheck
