// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The order of nodes whose enclosures do not decide, by exact values.
#include <span>
#include <vector>

#include "algorithms/reeb/tile_complex.hpp"
#include "kernel/predicates/critical_value.hpp"

namespace crest::reeb {

struct ValuedNode {
  kernel::CriticalValue value;
  kernel::ValueRange range;  ///< encloses it
  Index node;
};

/// Writes the nodes of `items` to `nodes` by value, equal values by number, and sets tied[i] for
/// i > 0 where nodes[i] has the value of nodes[i - 1]. Adds these decisions to `counts`.
/// Equal data are found first: a value is computed once however many nodes have it.
/// Cost: O(n log n) comparisons of data, O(k log k) of exact values where k data are different.
void sort_exactly(std::vector<ValuedNode>& items, std::span<Index> nodes,
                  std::span<std::uint8_t> tied, kernel::StageCounts& counts);

}  // namespace crest::reeb
