// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tests of many simplices of the trees, by all threads.
#include <tbb/blocked_range.h>

#include <vector>

#include "algorithms/modes/cell_test.hpp"
#include "algorithms/modes/vertices.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {

/// Calls test(first, cells, exact) for groups of simplices with these corners, at most kTogether in
/// each, the first of them being `first`. D: their dimension.
template <int D, class Test>
void for_all_groups(Vertices& vertices, std::span<const std::array<Index, D + 1>> corners,
                    const Test& test) {
  const std::size_t groups = (corners.size() + kTogether - 1) / kTogether;
  const auto one = [&](std::size_t group) {
    const std::size_t first = group * kTogether,
                      count = std::min(kTogether, corners.size() - first);
    std::array<Corners<D>, kTogether> cells;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k <= D; ++k) cells[i][k] = &vertices.tensor(corners[first + i][k]);
    test(first, std::span<const Corners<D>>(cells.data(), count),
         [&](std::size_t i) { return vertices.exact(corners[first + i]); });
  };
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, groups, 4), [&](const auto& range) {
    for (std::size_t g = range.begin(); g < range.end(); ++g) one(g);
  });
}

/// What test_cells says of simplices with these corners.
template <int D>
std::vector<CellResult<D>> test_all(Vertices& vertices,
                                    std::span<const std::array<Index, D + 1>> corners,
                                    const Level& level) {
  std::vector<CellResult<D>> results(corners.size());
  for_all_groups<D>(vertices, corners, [&](std::size_t first, auto cells, auto exact) {
    test_cells<D>(cells, exact, level, {results.data() + first, cells.size()});
  });
  return results;
}

}  // namespace crest::modes
