// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Reeb graph of a function on a triangulated surface whose vertices are totally ordered.
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::reeb {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;

/// Triangles over vertices 0 .. rank.size() - 1, a 2-manifold with boundary, orientable or not,
/// every vertex in a triangle; rank is a permutation, order its inverse. (A TileComplex is one.)
struct OrderedComplex {
  std::span<const Triangle> triangles;
  std::span<const Index> rank, order;
};

enum class NodeKind : std::uint8_t { minimum, saddle, maximum };

/// A critical vertex: one whose link has not exactly one lower and one upper run
/// (certify/reeb/SPEC.md, "Types"). It may have degree 2 in the graph: where a contour turns
/// from a path into a cycle, or at a saddle of a non-orientable surface.
struct ReebNode {
  Index vertex;
  NodeKind kind;
  std::uint8_t on_boundary;
  std::uint32_t multiplicity;  ///< max(lower runs, upper runs) - 1 for a saddle, else 1
  std::int32_t index;          ///< 1 - Euler characteristic of the lower link
};

/// A family of contours between two critical vertices: positions in `nodes`, lower first.
struct ReebArc {
  Index lower, upper;
  Index strand;  ///< the contour just above the lower vertex crosses the edge from it to this
                 ///< vertex: the least such
  std::uint8_t open_below, open_above;  ///< the contours are paths (1) or cycles (0) near the lower
                                        ///< and upper end (equal: every change is a node)
};

struct ReebGraph {
  std::vector<ReebNode> nodes;  ///< ascending in the order
  std::vector<ReebArc> arcs;    ///< by (lower, upper, rank of strand)
  Index components = 0;
  /// arcs - nodes + components.
  Index loops() const { return static_cast<Index>(arcs.size() - nodes.size()) + components; }
};

/// A sweep over the critical vertices alone, contours kept as sequences of descending paths
/// (strands.hpp, contour_sweep.hpp).
/// Cost: O(n + c log c) time for n vertices and c critical ones (counted with multiplicity), O(n)
///   memory.
ReebGraph reeb_graph(const OrderedComplex& complex);

/// The same graph, and for every vertex the arc it lies on, or kNone at nodes.
/// Cost: the graph's and O(n) where critical vertices are few; O(n log n) time, O(n) memory.
struct GraphAndArcs {
  ReebGraph graph;
  std::vector<Index> arc_of_vertex;
};
GraphAndArcs reeb_graph_and_arcs(const OrderedComplex& complex);

}  // namespace crest::reeb
