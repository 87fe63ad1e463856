// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The arcs of vertices by walks over the surface, from a sweep that stopped at nodes alone.
#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/reeb/swept_graph.hpp"

namespace crest::reeb {

/// Along an edge of the surface the contour through a point of it stays on one arc as long as its
/// level lies between those of the arc's nodes. So
/// (1) a neighbour of a vertex of an arc lies on this arc, too, if its rank is between those of the
///     arc's nodes; a neighbour of a node lies on the arc of its run of the node's link, likewise;
/// (2) where its rank is beyond a node, the walk along the edge goes on along the node's arc on its
///     other side, if there is only one.
/// What (1) and (2) do not reach is left: vertices beside nodes with several arcs where these are
/// so short that no edge lies in them.
class ArcFlood {
 public:
  /// Requires: a sweep without stops but the critical vertices.
  ArcFlood(const OrderedComplex& complex, VertexStars& stars, const SweptGraph& swept);

  /// The arcs; kNone at nodes and for those that are left.
  const std::vector<Index>& labels() const { return arc_of_; }
  /// A mark for each that is left; empty if none is.
  std::vector<std::uint8_t> unlabelled() const;

 private:
  bool on_arc(Index v, Index arc) const;
  void label(Index v, Index arc);
  void start_at_nodes();
  void flood();
  Index walk(Index arc, Index v) const;
  bool label_by_walk(Index v);
  void go_past_nodes();

  const OrderedComplex& complex_;
  VertexStars& stars_;
  const SweptGraph& swept_;
  std::vector<Index> arc_of_;
  std::vector<std::uint8_t> is_node_;
  std::vector<std::array<Index, 2>> span_;      ///< by arc: the ranks of its nodes
  std::vector<Index> only_below_, only_above_;  ///< by node: its only arc there, else kNone
  std::vector<Index> queue_;                    ///< labelled vertices whose neighbours are to come
};

}  // namespace crest::reeb
