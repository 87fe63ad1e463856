// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a certificate says that a degenerate tensor of a face is.
#include <array>
#include <cstdint>

namespace crest::certify::curves {

using u32 = std::uint32_t;

/// A listed point's box of weights of corners 0 and 1, open.
struct Box {
  std::array<double, 2> low, high;
  int type;    ///< +1 linear, -1 planar
  u32 listed;  ///< place among the listed points
};

}  // namespace crest::certify::curves
