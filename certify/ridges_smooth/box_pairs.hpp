// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which boxes meet (one sheet, disjoint umbilics).
#include <array>
#include <utility>
#include <vector>

#include "kernel/arithmetic/range.hpp"

namespace crest::certify::smooth {

/// All pairs (i, k) of a box a[i] and a box b[k] that have a common point, ascending.
/// Throws Reject if there are more than `most`. Cost: n log^3 n, and `most`.
std::vector<std::pair<std::size_t, std::size_t>> meeting_boxes(
    const std::vector<std::array<kernel::Range, 3>>& a,
    const std::vector<std::array<kernel::Range, 3>>& b, std::size_t most);

}  // namespace crest::certify::smooth
