// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contours below and above a rising level, as sequences of strands.
#include <vector>

#include "algorithms/reeb/contour_sequences.hpp"
#include "algorithms/reeb/strands.hpp"

namespace crest::reeb {

/// Surgery at a stop v with lower runs L and upper runs U. A gap of its link is a place between
/// two runs. Just below v the contour through L_i comes from one of its gaps, crosses the strand
/// of L_i and leaves through the other; just above v a contour crosses U_j from gap to gap. So:
/// take every strand x_i out of its sequence, which leaves stretches with their ends at gaps, and
/// join stretches and the strands of the U_j at their common gaps. What comes out are the
/// contours above v.
class ContourSweep {
 public:
  explicit ContourSweep(const StrandLists& strands);

  /// Fetches what the stops soon after place i will need: they lie anywhere in memory.
  void announce(const std::vector<Index>& stops, std::size_t i) const;
  /// Goes past a critical vertex, node number `node`: ends arcs and starts arcs.
  void pass_node(Index stop, Index node);
  /// Goes past a stop that is not critical. Returns the arc it lies on.
  Index pass_regular(Index stop);

  /// In the order in which they start.
  std::vector<ReebArc> arcs;
  /// By lower and upper run: the arc of the contours that cross it.
  std::vector<Index> arc_of_lower_run, arc_of_upper_run;

 private:
  struct Piece {
    Index root = kNone;
    std::array<Index, 2> ends = {kNone, kNone};  ///< front and back: 2 gap + side, or kNone
    Index arc = kNone;
    Index least = kNone;      ///< of the upper runs in it
    Index joined_to = kNone;  ///< the piece it has become part of
    bool closed = false;
  };
  Index new_piece();
  void reverse(Index piece);
  void set_end(Index piece, int which, Index end);
  void set_root(Index piece, Index root);
  Index find_piece(Index strand);
  void cut_lower_runs(Index stop);
  void cut_at(Index strand, Index gap_before, Index gap_after);
  void join_upper_runs(Index stop);
  void join_at(Index gap);

  void record_upper_runs(Index stop);

  const StrandLists& strands_;
  ContourSequences sequences_;
  std::vector<Piece> pieces_;
  std::vector<Index> free_pieces_;
  std::vector<Index> run_pieces_;  ///< of the upper runs of this surgery
  std::vector<Index> touched_;     ///< pieces of this surgery, some dropped again
  std::vector<Index> end_owner_;   ///< by end: the piece that has it
};

}  // namespace crest::reeb
