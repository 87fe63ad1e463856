// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How sheets cross a face of the grid: its critical edges in groups, each an arc, an end or a
// junction. The rule sees the face only, so that both cells agree.
#include "algorithms/extremal/edges.hpp"

namespace crest::extremal {

/// The edges in cyclic order: with p the lowest node and a, b the axes in it,
/// (p, a), (p + a, b), (p + b, a), (p, b).
struct Face {
  std::array<Index, 4> edges;
  std::array<std::int8_t, 4> group;  ///< its lowest member; -1: not critical
  int critical = 0;
  bool tested = true;    ///< all four edges are
  bool swapped = false;  ///< ambiguous, paired as {1, 2}, {3, 0}; else as {0, 1}, {2, 3}

  bool odd() const { return tested && critical % 2 == 1; }
  bool ambiguous() const { return tested && critical == 4; }
};

/// A cell's 12 edges, an image's square's 4. The first in number need not be the first here.
std::array<Index, 12> edges_of_cell(const Grid& grid, const Node& cell);

class Faces {
 public:
  Faces(const Fields& fields, const Nodes& nodes, const Cells& cells, const Edges& edges)
      : fields_(fields), nodes_(nodes), cells_(cells), edges_(edges) {}

  /// The face across `normal` with lowest node p. Requires: it lies in the grid.
  Face face(const Node& p, std::size_t normal) const;
  /// Sheets of a cell: each of its 12 edges' sheet, numbered from 0 by their lowest edge; -1: not
  /// critical. Edges in the order of edges_of_cell.
  std::array<std::int8_t, 12> sheets(const Node& cell) const;

 private:
  bool pairs_swapped(const Node& p, std::size_t normal) const;

  const Fields& fields_;
  const Nodes& nodes_;
  const Cells& cells_;
  const Edges& edges_;
};

}  // namespace crest::extremal
