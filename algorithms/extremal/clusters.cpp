// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/extremal/components.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::extremal {

Clusters::Clusters(const Fields& fields, const Cells& cells, const Edges& edges, const Faces& faces)
    : fields_(fields) {
  const Grid& g = fields.grid();
  // For the definition by Hess the theorem is not proven; for images there is none.
  if (!fields.structure() || g.dimension() == 2) return;
  for (std::size_t v = 0; v < g.nodes(); ++v)
    if (cells.regular(v)) members_.push_back(v);
  const auto find = [&](std::size_t v) {
    return static_cast<Index>(std::lower_bound(members_.begin(), members_.end(), v) -
                              members_.begin());
  };
  kernel::DisjointSets sets(static_cast<Index>(members_.size()));
  std::vector<bool> bad(members_.size());
  for (Index m = 0; m < members_.size(); ++m) {
    const Node v = g.node(members_[m]);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const Node other = {v[0] + x, v[1] + y, v[2] + z};
          const std::size_t n = g.is_cell(other) ? g.index(other) : 0;
          if (!g.is_cell(other) || !(cells.regular(n) || cells.state(n) == CellState::empty))
            bad[m] = true;
          else if (n < members_[m] && cells.regular(n))
            sets.unite(m, find(n));
        }
    const auto in = faces.cell_edges(v);
    if (std::none_of(in.begin(), in.end(), [&](Index e) { return edges.critical(e); })) continue;
    const auto sheets = faces.sheets(v);
    if (*std::max_element(sheets.begin(), sheets.end()) > 0) bad[m] = true;
    for (std::size_t normal = 0; normal < 3; ++normal)
      for (int far = 0; far < 2; ++far) {
        Node p = v;
        p[normal] += far;
        if (faces.face(p, normal).critical == 4) bad[m] = true;
      }
  }
  cluster_.resize(members_.size());
  bad_.assign(members_.size(), false);
  mixed_.assign(members_.size(), false);
  for (Index m = 0; m < members_.size(); ++m) {
    cluster_[m] = sets.find(m);
    if (bad[m]) bad_[cluster_[m]] = true;
    if (cells.state(members_[m]) != CellState::regular_extremal) mixed_[cluster_[m]] = true;
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
