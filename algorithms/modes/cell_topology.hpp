// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The surface of one side in a graph cell, from the curves on its facets (README.md, the lemma):
// loops of arcs, and which loops bound one piece, where the three cases tell.
#include <optional>
#include <vector>

#include "algorithms/modes/faces.hpp"

namespace crest::modes {

/// An arc of Faces::arcs(), from its first root to its second or back.
struct LoopArc {
  Index arc;
  bool forward;
};
using Loop = std::vector<LoopArc>;

/// Each piece by its loops: one for a disk.
using Piece = std::vector<Loop>;

/// How many components a cell's surface has, or nothing where the three cases do not tell.
/// (Refereed 1: counts alone do not say which of three loops bound one piece.)
std::optional<std::size_t> piece_count(std::size_t loops, std::size_t above, std::size_t below);

class CellTopology {
 public:
  /// Facet i lies opposite corner i of a cell with direction w (sum 0). Requires: all facets are
  /// closed.
  CellTopology(Faces& faces, const std::array<Index, 4>& facets,
               const std::array<std::int16_t, 4>& w)
      : faces_(faces), facets_(facets), w_(w) {}

  /// The number of pieces of a side; nothing where the rule does not tell.
  std::optional<std::size_t> count(Side side);
  /// The same where loops alone tell. Only reads the trees.
  std::optional<std::size_t> count_by_loops(Side side) const;
  /// The pieces. Requires: count() was that many. Only reads the trees.
  std::vector<Piece> pieces(Side side, std::size_t count) const;

 private:
  struct Interval {
    Index line;
    std::size_t number;  ///< roots of the side on the line before it
    Index parent;
    bool above;
  };
  /// Walks around all loops: start() each, add() its arcs. False if they do not close.
  template <class Start, class Add>
  bool trace(Side side, Start&& start, Add&& add) const;
  std::optional<std::size_t> loop_count(Side side) const;
  /// Components of the closed half where w has that sign, above or below.
  std::size_t components(Side side, int sign, bool above);
  void add_face(Side side, Index face);
  Index interval(Side side, Index line, std::size_t number);
  Index find(Index i);
  void unite(Index a, Index b);

  Faces& faces_;
  std::array<Index, 4> facets_;
  std::array<std::int16_t, 4> w_;
  std::vector<Interval> intervals_;
};

}  // namespace crest::modes
