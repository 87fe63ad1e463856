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

/// Lines are chains of feature edges: mesh edges that separate patches or end inside one.
struct FeatureGraph {
  std::vector<std::vector<Index>> nodes;         ///< vertices ascending, by smallest vertex
  std::vector<std::array<Index, 2>> node_edges;  ///< feature edges inside nodes
  std::vector<FeatureLine> lines;
  std::vector<Label> labels;  ///< V
  /// F: component of the faces that no feature edges separate, by smallest face; kNone for the
  /// faces of a component of the mesh whose vertices are all marked.
  std::vector<Index> face_patch;
  std::vector<Index> patch_of;     ///< V: the patch of the faces around; kNone on feature edges
  std::vector<Index> patch_sizes;  ///< vertices of each patch, by its smallest face

  Index count(LineKind kind) const;
};

/// The feature edges of a marked set: the edges of its complex after faces with three marked
/// corners collapsed, each through an edge whose other face is not one of them, the flattest edge
/// first. So lines meet in a vertex where three of them share a face, as at a corner of a box.
/// Nodes: clusters of vertices with three or more feature edges or in a face that cannot collapse,
/// joined by such edges.
/// (The paper takes c_i > 4; three lines that meet in a marked triangle have c_i = 4 at each
/// corner, so that rule misses them.)
/// Requires: the marks are thin (Thinner::pre_prune), or everything is one big node.
/// Guarantees: every marked vertex is in exactly one node or in the inside of exactly one line. The
///   feature edges have the topology of the marked complex, patches are the components of the
///   unmarked vertices.
/// Cost: O(V).
FeatureGraph build_feature_graph(const kernel::TriangleMesh& mesh, const Marks& marks);

/// The feature edges are those given: one mark an edge. Nodes: single vertices with three or more.
/// A line that comes from inside the mesh to its boundary ends there.
/// Guarantees: every feature edge is in exactly one line. A patch may have no vertices.
FeatureGraph build_edge_graph(const kernel::TriangleMesh& mesh, const Marks& edges);

/// Marks the patches with fewer than `least` vertices; the largest patch is never marked.
Marks fill_small_patches(const FeatureGraph& graph, const Marks& marks, Index least);

/// How many edges a gap may have. Between marked vertices one edge is none: it is in the set.
struct Gap {
  Index shortest, longest;
};

/// Paths that join pairs of open ends in one patch, from end to end: shortest ones through the
/// patch's vertices that no other path takes, nearest pairs first. Ends of the same line are joined
/// only if the line is more than twice as long as the gap.
/// Cost: O(open ends times vertices within `longest` rings).
std::vector<std::vector<Index>> joining_paths(const kernel::TriangleMesh& mesh,
                                              const FeatureGraph& graph, Gap gap);

}  // namespace crest::feature_lines
