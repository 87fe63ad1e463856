// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The trees of a level as nodes: edges, faces and cells of the subdivision (SPEC.md, "Trees").
#include "certify/modes/domain.hpp"

namespace crest::certify::modes {

/// The part at the first end is the next node.
struct EdgeNode {
  u32 first, second;  ///< vertices
  u32 other = kNone;  ///< the part at the second end; kNone: a leaf
  u32 root = 0;       ///< the first of its roots
  std::uint8_t roots = 0;
  bool open = false;
  bool needed = false;  ///< to be checked: a decided face has it

  bool leaf() const { return other == kNone; }
};

/// An edge with a direction.
struct Side {
  u32 node;
  bool reversed;
};

/// The part in which the new vertex takes the place of corner k + 1 is `near`, the other `far`.
struct FaceNode {
  std::array<u32, 3> corners;
  std::array<Side, 3> edges;    ///< edge k from corner k to corner k + 1
  std::uint8_t code;            ///< of modes_code
  std::uint8_t sides;           ///< tetrahedra at it: 1 or 2
  std::uint8_t open_sides = 0;  ///< cells at it where nothing is claimed
  bool needed = false;          ///< to be checked: stated, or a decided cell has it
  u32 near = kNone, far = kNone, inner = kNone;  ///< of a split; inner: an edge
  u32 witness = 0, arc = 0;                      ///< its own; the first of its arcs
  u32 arcs = 0;

  bool leaf() const { return code > 2; }
};

/// A leaf.
struct Cell {
  std::array<u32, 4> corners, facets;  ///< facet i does not have corner i
  u32 witness;
  std::uint8_t code;
};

struct Trees {
  std::vector<EdgeNode> edges;  ///< in preorder; the parts of a node come after it
  std::vector<FaceNode> faces;
  std::vector<Cell> cells;
  std::vector<u32> open_tets;  ///< whole tetrahedra that have corners where the tensor is zero
  // Roots of the trees.
  std::vector<std::array<u32, 2>> edge_corners;
  std::vector<std::array<u32, 3>> face_corners;
  std::vector<u32> edge_roots, face_roots;

  /// Marks what the decided cells, cones and fans stand on.
  void mark_needed(const Domain& domain, const Field& field);
  /// Places of the trees' roots; kNone if there is none.
  u32 edge(u32 a, u32 b) const;
  u32 face(const std::array<u32, 3>& corners) const;
};

/// Throws Reject unless the codes are those of trees that fit one another, and all lists end where
/// the codes do.
Trees read_trees(const ModeLevel& level, const Domain& domain, Field& field);

}  // namespace crest::certify::modes
