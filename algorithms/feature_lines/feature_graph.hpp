// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The structure of thin feature lines (paper 001, section 3.4.4).
#include <array>

#include "algorithms/feature_lines/marks.hpp"

namespace crest::feature_lines {

enum class LineKind : std::uint8_t {
  arc,      ///< both ends at nodes or at the mesh's boundary
  branch,   ///< one open end
  loop,     ///< closed, touches no node
  isolated  ///< both ends open
};
enum class EndKind : std::uint8_t { open, node, boundary, none };

/// A polyline along mesh edges. vertices: from end to end; at a node the node's vertex that the
/// line comes from is included; a loop does not repeat its first vertex.
struct FeatureLine {
  LineKind kind = LineKind::isolated;
  std::vector<Index> vertices;
  std::array<EndKind, 2> ends{EndKind::none, EndKind::none};
  std::array<Index, 2> nodes{kNone, kNone};  ///< number of the node at an end
  double length = 0;                         ///< units of the input
};

/// What a vertex belongs to.
enum class Label : std::uint8_t { patch, node, arc, branch, loop, isolated };

/// Nodes: connected clusters of marked vertices with three or more marked neighbours or in a face
/// with three marked corners. (The paper takes c_i > 4; three lines that meet in a marked triangle
/// have c_i = 4 at each corner, so that rule misses them.)
struct FeatureGraph {
  std::vector<std::vector<Index>> nodes;         ///< vertices ascending, by smallest vertex
  std::vector<std::array<Index, 2>> node_edges;  ///< mesh edges inside nodes
  std::vector<FeatureLine> lines;
  std::vector<Label> labels;       ///< V
  std::vector<Index> patch_of;     ///< V: connected set of unmarked vertices; kNone if marked
  std::vector<Index> patch_sizes;  ///< vertices of each patch, by smallest vertex

  Index count(LineKind kind) const;
};

/// Requires: the marks are thin (Thinner::pre_prune), or everything is one big node.
/// Guarantees: every marked vertex is in exactly one node or in the inside of exactly one line.
/// Cost: O(V).
FeatureGraph build_feature_graph(const kernel::TriangleMesh& mesh, const Marks& marks);

/// Marks the patches with fewer than `least` vertices; the largest patch is never marked.
Marks fill_small_patches(const FeatureGraph& graph, const Marks& marks, Index least);

/// Joins pairs of open ends in one patch by a shortest path of at most `longest` edges through its
/// unmarked vertices, nearest pairs first. Ends of the same line are joined only if the line is
/// more than twice as long as the gap. Returns how many pairs were joined in `marks`.
/// Cost: O(open ends times vertices within `longest` rings).
Index close_branches(const kernel::TriangleMesh& mesh, const FeatureGraph& graph, Index longest,
                     Marks& marks);

}  // namespace crest::feature_lines
