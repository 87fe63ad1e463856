// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which edges are tested, where g changes its sign along them, and of which type the zeros are
// (SPEC.md, theorem 14 (i)).
#include "certify/extremal/cells.hpp"

namespace crest::certify::extremal {

struct Edges {
  static constexpr std::uint8_t kUntested = 0, kPlain = 1, kCritical = 2;  ///< + type

  Sparse<std::uint8_t> state;  ///< of every edge
  std::vector<u32> critical;   ///< ascending

  explicit Edges(const Grid& grid) : state(size_t{grid.dimension} * grid.count, kUntested) {}

  bool is_critical(u32 edge) const { return state[edge] >= kCritical; }
  bool is_extremal(u32 edge) const {
    return state[edge] == kCritical + extremal_code::kExtremalEdge;
  }
  bool is_undecided(u32 edge) const {
    return state[edge] == kCritical + extremal_code::kUndecidedType;
  }
};

/// Requires: the cells' codes are proven. Throws Reject unless trees and types hold.
Edges check_edges(const ExtremalCertificate& c, const Splines& splines, const Cells& cells);

}  // namespace crest::certify::extremal
