// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "algorithms/extremal/sheet_mesh.hpp"

namespace crest::extremal {
namespace {

template <class T>
void make_set(std::vector<T>& v) {
  tbb::parallel_sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace

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
  make_set(r);
  return r;
}

void count_crossings(const Fields& fields, const Edges& edges, const Faces& faces, Counts& counts) {
  const Grid& g = fields.grid();
  for (const Index f : crossed_faces(fields, edges)) {
    const Face face = faces.face(g.node(f / 3), f % 3);
    counts.odd_faces += face.odd() ? 1 : 0;
    counts.ambiguous_faces += face.ambiguous() ? 1 : 0;
    counts.junction_edges += face.odd() && face.critical == 3 ? 1 : 0;
  }
  std::vector<std::size_t> cells;
  for (const CriticalEdge& c : edges.critical_edges())
    for (int i = 0; i < 4; ++i) {
      Node cell = g.node(c.edge / 3);
      cell[next(c.edge % 3)] -= i & 1;
      cell[after_next(c.edge % 3)] -= i >> 1;
      if (g.is_cell(cell)) cells.push_back(g.index(cell));
    }
  make_set(cells);
  for (const std::size_t c : cells) {
    const auto sheets = faces.sheets(g.node(c));
    counts.sheets_split += *std::max_element(sheets.begin(), sheets.end()) > 0 ? 1 : 0;
  }
}

}  // namespace crest::extremal
