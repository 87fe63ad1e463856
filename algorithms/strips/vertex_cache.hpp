// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What strips cost a graphics card that keeps the last vertices it has transformed.
#include "algorithms/strips/strips.hpp"

namespace crest::strips {

/// What a graphics card with room for this many vertices is expected to keep.
inline constexpr std::size_t kCacheEntries = 16;

/// Average cache miss ratio: vertices not among the last `entries` that missed, a face.
/// Requires: 0 < entries.
double average_cache_miss_ratio(const Strips& strips, std::size_t vertices, std::size_t faces,
                                std::size_t entries);

/// The same strips in another order: next comes the one whose first vertices are most often among
/// the last `entries` sent, the first of several, or else the first that is left.
/// Cost: O(V + sent) for bounded valences.
Strips in_cache_order(const Strips& strips, std::size_t vertices, std::size_t entries);

}  // namespace crest::strips
