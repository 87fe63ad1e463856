// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Leaf cells: the pieces of the levels in them, bounded by loops of arcs (SPEC.md, lemma 7).
#include "certify/modes/faces.hpp"

namespace crest::certify::modes {

/// An arc on the boundary of a piece; its ends are numbered within the cell.
struct HalfArc {
  u32 arc;    ///< place in ModeLevel::arcs
  u32 piece;  ///< within the cell
  u32 first, second;
};
struct CellPieces {
  std::vector<HalfArc> arcs;
  std::vector<std::int8_t> levels;  ///< of each piece
  std::vector<u32> loops;           ///< of each piece
  u32 roots = 0;
};

/// An arc of a face, with the roots it joins.
struct FaceArc {
  u32 arc, first, second;
  std::int8_t level;
};
/// Leaves below a node; throws Reject if one is open.
void list_leaves(const Trees& trees, u32 face, std::vector<u32>& leaves);
void list_arcs(const LevelContext& context, u32 leaf, std::vector<FaceArc>& arcs);

/// Lemma 7 (b): components of a level in a cell, by its boundary loops, the components of what is
/// above where w leaves and of what is not where it enters.
constexpr u32 count_components(u32 loops, u32 above, u32 below) {
  return loops <= 1 ? loops : above + below - 1;
}
/// Whether that tells which loops bound one component: the three cases.
constexpr bool is_pairing_known(u32 loops, u32 components) {
  return components == loops || components == 1;
}

/// Throws Reject unless each cell is rejected rightly, or its witness holds and its pieces are as
/// many as listed and known. `pieces` has room for one a cell.
void check_cells(const LevelContext& context, std::span<const Cell> cells,
                 std::span<CellPieces> pieces, Worker& worker);

}  // namespace crest::certify::modes
