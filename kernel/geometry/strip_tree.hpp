// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The strip tree: a surface cut into triangle strips that form binary trees, one a component (paper
// 001, section 4.2, algorithm 4.1). It depends on connectivity alone.
#include <span>
#include <vector>

#include "kernel/geometry/corner_table.hpp"

namespace crest::kernel {

/// Through which edge a strip leaves a triangle. Of a triangle entered through the half-edge h the
/// left edge is next_half(h), which leads to the tip, the right edge previous_half(h).
enum class StripExits {
  zigzag,  ///< left, right, left, ...: a zig-zag strip
  fan      ///< always left: a fan strip
};

struct StripTree {
  struct Node {
    Index begin, length;  ///< its half-edges in `entered`
    Index left, right;    ///< the nodes behind the edges of its last triangle, or kNone
    /// For two children of which the right one was conquered from the left one: the half-edge
    /// behind the right edge (right is kNone); else kNone.
    Index split;
  };
  std::vector<Node> nodes;     ///< in preorder, left before right, components one after another
  std::vector<Index> entered;  ///< each triangle's half-edge through which its strip enters it
  std::vector<Index> roots;    ///< node of each component
  /// Of closed components the half-edge, across the root's gate, of the triangle that is in no
  /// strip; of others kNone.
  std::vector<Index> removed;
};

/// Grows strips from a gate, a half-edge of the first triangle, until their tip is a vertex met
/// before. `gates`: one a component, on the boundary where there is one; empty: the first boundary
/// half-edges, or the first ones.
/// Shapes: F faces as `table` was made from.
/// Guarantees: every triangle is in one strip or removed; n = v - 2 + 2 s nodes and s splits a
///   component, s = 2 g + h - 1 with h boundary loops, 2 g if it is closed.
/// Cost: O(V + F).
StripTree grow_strips(const CornerTable& table, std::span<const Triangle> faces, StripExits exits,
                      std::span<const Index> gates = {});

/// The nodes of all trees in postorder: left, right, node.
std::vector<Index> postorder(const StripTree& tree);

}  // namespace crest::kernel
