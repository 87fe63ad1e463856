// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sequences that are cut and joined anywhere and reversed as a whole: splay trees over elements
// 0 .. n - 1 (Sleator and Tarjan, Self-adjusting binary search trees, 1985).
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// A sequence is named by the root of its tree, kNone being the empty one; most calls change the
/// root. Every sequence carries a label below 2^31. An element has a *sense*, which turns when its
/// sequence is reversed.
/// Cost: amortized O(log n) a call; 16 bytes an element.
class ContourSequences {
 public:
  explicit ContourSequences(Index elements) : nodes_(elements) {}

  void set_sense(Index x, bool turned) { nodes_[x].flags = turned ? kTurned : 0; }

  /// The sequence first, first + 1, ..., last - 1 of elements in no sequence. Returns its root.
  Index build(Index first, Index last);

  void prefetch(Index x) const { __builtin_prefetch(&nodes_[x], 1); }

  /// Makes x the root of its sequence.
  void splay(Index x);

  /// Requires of the next four: x is a root.
  Index label(Index x) const { return nodes_[x].parent & ~kRoot; }
  void set_label(Index x, Index label) { nodes_[x].parent = kRoot | label; }
  bool turned(Index x) const { return (nodes_[x].flags & kTurned) != 0; }
  /// Takes x out of its sequence; returns what was before and after it.
  std::array<Index, 2> remove(Index x);

  /// Returns the root of a followed by b.
  Index join(Index a, Index b);
  void reverse(Index root);

 private:
  static constexpr Index kRoot = 0x80000000u;
  static constexpr Index kTurned = 1, kPending = 2;
  struct Node {
    Index left = kNone, right = kNone;
    Index parent = kRoot;  ///< of a root: kRoot | label
    Index flags = 0;       ///< kTurned, kPending: the children's subtrees are to be reversed
  };
  bool is_root(Index x) const { return (nodes_[x].parent & kRoot) != 0; }
  Index build_below(Index first, Index last, Index parent);
  void rotate(Index x);
  void settle(Index x);

  std::vector<Node> nodes_;
  std::vector<Index> path_;
  bool any_reversed_ = false;
};

}  // namespace crest::reeb
