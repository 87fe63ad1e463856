// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The triangles around every vertex, and its link in order.
#include <span>
#include <vector>

#include "algorithms/reeb/reeb_graph.hpp"

namespace crest::reeb {

/// The neighbours of a vertex in the order of its link: a cycle, or a path at the boundary.
struct Link {
  std::vector<Index> vertices;
  bool closed = false;
};

/// Memory: 8 bytes a corner, 4 a vertex; one byte a corner more where triangles disagree about
/// orientation.
class VertexStars {
 public:
  /// The side of a triangle across from the vertex, in the triangle's direction.
  using Side = std::array<Index, 2>;

  VertexStars(std::span<const Triangle> triangles, Index vertex_count);

  std::span<const Side> star(Index v) const {
    return {sides_.data() + begin_[v], sides_.data() + begin_[v + 1]};
  }

  /// The link of v in its *direction*: that of the first triangle in its star. Cost: the degree.
  void link(Index v, Link& out);

  /// Whether the directions of the links of v and its neighbour w disagree along the edge v w.
  bool flips(Index v, Index w) const { return !disagrees_.empty() && flips_in_some_triangle(v, w); }

 private:
  static constexpr Index kSmall = 24;
  void find_disagreements();
  bool flips_in_some_triangle(Index v, Index w) const;
  Index other_side(std::span<const Side> star, Index side, Index vertex) const;
  void walk(std::span<const Side> star, Index from, Link& out);
  void fill_slots(std::span<const Side> star);

  std::vector<Index> begin_;  ///< V + 1
  std::vector<Side> sides_;
  /// For every side 1 if its triangle runs against the link's direction; empty if none does.
  std::vector<std::uint8_t> disagrees_;
  std::vector<std::array<Index, 2>> slots_;  ///< for large stars: the two sides at a link vertex
};

}  // namespace crest::reeb
