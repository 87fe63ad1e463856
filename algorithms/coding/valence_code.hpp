// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Connectivity by valences (Touma and Gotsman 1998, Alliez and Desbrun 2001), with mixed contexts.
// One routine codes and decodes (docs/cmc-format.md, "Method valence").
#include <vector>

#include "algorithms/coding/closed_surface.hpp"
#include "algorithms/coding/connectivity.hpp"
#include "algorithms/coding/range_coder.hpp"

namespace crest::coding {

/// The section's bytes; `order` says where vertices and faces went.
Bytes encode_valences(const Surface& surface, CodedOrder& order);

/// Requires: `counts` of the header.
/// Throws: StreamError. The faces are not checked: a doubled edge may have come through.
std::vector<Triangle> decode_valences(std::span<const std::uint8_t> bytes, const Counts& counts,
                                      Index max_faces);

}  // namespace crest::coding
