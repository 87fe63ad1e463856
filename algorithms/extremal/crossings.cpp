// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "algorithms/extremal/sheet_mesh.hpp"

namespace crest::extremal {
std::vector<Index> crossed_faces(const Fields& fields, const Edges& edges) {
  const Grid& g = fields.grid();
  std::vector<Index> r;
  for (const CriticalEdge& c : edges.critical_edges()) {
    const std::size_t a = c.edge % 3;
    for (const std::size_t normal : {next(a), after_next(a)}) {
      if (g.dimension() == 2 && normal != 2) continue;
      const std::size_t other = 3 - a - normal;
      for (int low = 0; low < 2; ++low) {
        Node p = g.node(c.edge / 3);
        p[other] -= low;
        if (p[other] >= 0 && p[other] < g.size[other] - 1)
          r.push_back(static_cast<Index>(3 * g.index(p) + normal));
      }
    }
  }
  tbb::parallel_sort(r.begin(), r.end());
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

}  // namespace crest::extremal
