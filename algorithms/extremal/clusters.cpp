// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/extremal/components.hpp"

namespace crest::extremal {

Clusters::Clusters(const Grid& grid, const CellRecords& cells) {
  // By the definition by Hess there are no regular cells: the theorem is not proven.
  std::vector<bool> extremal;
  std::size_t n = 0;
  for (const certify::CellRun& run : cells.runs)
    for (Index i = 0; i < run.length; ++i, ++n) {
      const auto s = static_cast<CellState>(cells.codes[n]);
      if (s != CellState::regular && s != CellState::regular_extremal) continue;
      members_.push_back(run.first + i);
      extremal.push_back(s == CellState::regular_extremal);
    }
  kernel::DisjointSets sets(static_cast<Index>(members_.size()));
  join_neighbours(grid, sets);
  cluster_.resize(members_.size());
  bad_.assign(members_.size(), false);
  mixed_.assign(members_.size(), false);
  for (Index m = 0; m < members_.size(); ++m) {
    cluster_[m] = sets.find(m);
    if (cells.fit[m] == 0) bad_[cluster_[m]] = true;
    if (!extremal[m]) mixed_[cluster_[m]] = true;
  }
}

/// Joins members that share a point. A row's last node and the last row's are no cells: so numbers
/// that differ by one, or by a row and so on, are neighbours.
void Clusters::join_neighbours(const Grid& grid, kernel::DisjointSets& sets) const {
  const std::size_t row = grid.stride[1], slice = grid.stride[2];
  std::vector<std::size_t> back{row};
  if (grid.dimension() == 3) back.insert(back.end(), {slice - row, slice, slice + row});
  for (Index m = 1; m < members_.size(); ++m)
    if (members_[m - 1] + 1 == members_[m]) sets.unite(m, m - 1);
  for (const std::size_t distance : back) {
    Index other = 0;
    for (Index m = 0; m < members_.size(); ++m) {
      const auto middle =
          static_cast<std::int64_t>(members_[m]) - static_cast<std::int64_t>(distance);
      while (std::int64_t{members_[other]} < middle - 1) ++other;
      for (Index k = other; k < m && std::int64_t{members_[k]} <= middle + 1; ++k) sets.unite(m, k);
    }
  }
}

bool Clusters::proven(std::size_t cell) const {
  const auto at = std::lower_bound(members_.begin(), members_.end(), cell);
  return at != members_.end() && *at == cell &&
         !bad_[cluster_[static_cast<std::size_t>(at - members_.begin())]];
}

bool Clusters::extremal(std::size_t cell) const {
  const auto at = std::lower_bound(members_.begin(), members_.end(), cell);
  return proven(cell) && !mixed_[cluster_[static_cast<std::size_t>(at - members_.begin())]];
}

}  // namespace crest::extremal
