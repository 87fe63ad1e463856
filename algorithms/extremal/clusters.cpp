// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/extremal/components.hpp"
#include "algorithms/extremal/dual.hpp"

namespace crest::extremal {

Clusters::Clusters(const Fields& fields, const Cells& cells, const Edges& edges, const Faces& faces)
    : fields_(fields) {
  // By the definition by Hess the theorem is not proven.
  if (!fields.structure()) return;
  const std::size_t count = fields.grid().nodes();
  for (std::size_t v = 0; v < count; ++v)
    if (cells.regular(v)) members_.push_back(v);
  kernel::DisjointSets sets(static_cast<Index>(members_.size()));
  std::vector<bool> bad(members_.size());
  for (Index m = 0; m < members_.size(); ++m)
    bad[m] = !cells.proof(members_[m]).boxed || !join_neighbours(cells, m, sets) ||
             several_sheets(edges, faces, members_[m]);
  cluster_.resize(members_.size());
  bad_.assign(members_.size(), false);
  mixed_.assign(members_.size(), false);
  for (Index m = 0; m < members_.size(); ++m) {
    cluster_[m] = sets.find(m);
    if (bad[m]) bad_[cluster_[m]] = true;
    if (cells.state(members_[m]) != CellState::regular_extremal) mixed_[cluster_[m]] = true;
  }
}

/// Joins a member with those it touches; false if it touches what is neither regular nor empty.
bool Clusters::join_neighbours(const Cells& cells, Index m, kernel::DisjointSets& sets) const {
  const Grid& g = fields_.grid();
  const Dual dual(g);
  const Node v = g.node(members_[m]);
  const int reach = dual.plane() ? 0 : 1;
  bool good = true;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const Node other = {v[0] + x, v[1] + y, v[2] + z};
        if (!dual.inside(other)) {
          good = false;
          continue;
        }
        const std::size_t n = g.index(other);
        if (!cells.regular(n))
          good = good && cells.state(n) == CellState::empty;
        else if (n < members_[m])
          sets.unite(m, static_cast<Index>(std::lower_bound(members_.begin(), members_.end(), n) -
                                           members_.begin()));
      }
  return good;
}

/// Has the cell more than one sheet, or an ambiguous face?
bool Clusters::several_sheets(const Edges& edges, const Faces& faces, std::size_t cell) const {
  const Node v = fields_.grid().node(cell);
  if (fields_.grid().dimension() == 2) return faces.face(v, 2).critical > 2;
  const auto in = faces.cell_edges(v);
  if (std::none_of(in.begin(), in.end(), [&](Index e) { return edges.critical(e); })) return false;
  const auto sheets = faces.sheets(v);
  if (*std::max_element(sheets.begin(), sheets.end()) > 0) return true;
  for (std::size_t normal = 0; normal < 3; ++normal)
    for (int far = 0; far < 2; ++far) {
      Node p = v;
      p[normal] += far;
      if (faces.face(p, normal).critical == 4) return true;
    }
  return false;
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
