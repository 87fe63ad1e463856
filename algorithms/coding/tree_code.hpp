// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Connectivity by trees of strips in postorder (paper 001, section 4.2): methods fan and zigzag
// with mixed contexts, the static code with fixed probabilities and a proven bound
// (docs/cmc-format.md).
#include "algorithms/coding/range_coder.hpp"
#include "algorithms/coding/surface.hpp"

namespace crest::coding {

enum class TreeMethod { fan, zigzag, fixed };

/// The section's bytes; order: the half-edges of the decoded faces' first corners.
Bytes encode_tree(const Surface& surface, TreeMethod method, CodedOrder& order);

/// As decode_valences().
std::vector<Triangle> decode_tree(std::span<const std::uint8_t> bytes, TreeMethod method,
                                  const Counts& counts, Index max_faces);

}  // namespace crest::coding
