// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From feature regions to feature lines (paper 001, section 3.4.3, algorithm 3.1). Every removal
// here is of a simple vertex (topology.hpp), so the topology is kept; the order of the removals is
// the certificate's witness.
#include "algorithms/feature_lines/topology.hpp"

namespace crest::feature_lines {

/// Takes marked sets apart, vertex by vertex, and remembers the order.
class Thinner {
 public:
  /// field: one number a vertex, or none. Where the order of removals is free, the vertex with the
  /// smallest value goes first, the smaller number among equals, so that lines run along crests.
  /// Requires: marks.size() == V; mesh outlives the thinner; no value is NaN.
  Thinner(const kernel::TriangleMesh& mesh, Marks marks, std::vector<double> field = {});

  /// Algorithm 3.1 to its fixpoint: passes over the vertices that are no centres at the start of
  /// the pass; those beside a vertex that was a centre then, and that are simple, go. Ends when no
  /// such vertex is left. Cost: O(V): a vertex is looked at again only after a neighbour went.
  void skeletonize();

  /// Removes simple vertices with two or more marked neighbours, one at a time, those with most
  /// marked neighbours first: what remains are lines, nodes and tips. Cost: O(V log V).
  void pre_prune();

  /// Takes the tips away `rounds` times; where an open end is left, what was taken from it comes
  /// back (at a fork the longest chain). So branches of more than `rounds` vertices keep their
  /// length and shorter ones vanish. An isolated line of at most `rounds` vertices shrinks to a
  /// point, listed in dropped(). Ends with pre_prune(). Cost: O(V log V).
  void prune(Index rounds);

  const Marks& marks() const { return marks_; }
  const std::vector<Index>& removed() const { return removed_; }
  /// Isolated marked vertices, ascending, that stand for short isolated lines.
  const std::vector<Index>& dropped() const { return dropped_; }

 private:
  struct Taken {
    Index vertex, parent;
  };
  void take(Index v);
  void put_back(Index v);
  bool beside_centre(Index v) const;
  bool is_tip(Index v) const;
  bool goes_before(Index v, Index w) const;
  Index degree(Index v) const;
  std::vector<Taken> take_tips(Index rounds);
  void restore_open_ends(const std::vector<Taken>& history, Index rounds);

  const kernel::TriangleMesh& mesh_;
  Marks marks_;
  std::vector<double> field_;        ///< V or none
  std::vector<Index> unmarked_;      ///< V: unmarked neighbours; 0: a centre, if marked
  std::vector<Index> centre_until_;  ///< V: the pass in which it ceased to be a centre
  Index pass_ = 0;
  std::vector<Index> removed_, dropped_;
};

}  // namespace crest::feature_lines
