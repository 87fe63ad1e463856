// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the numbers of a Monge form stand in its 14 doubles.
#include <cstddef>

namespace crest::certify::field {

inline constexpr std::size_t d1 = 0, n = 3, k1 = 6, k2 = 7, b0 = 8, b1 = 9, b2 = 10, b3 = 11,
                             c0 = 12, c4 = 13;

}  // namespace crest::certify::field
