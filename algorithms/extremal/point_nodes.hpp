// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The octree of points with what is decided of its leaves, nodes and minimal edges.
#include <vector>

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/edges.hpp"
#include "algorithms/extremal/octree.hpp"
#include "algorithms/extremal/point_field.hpp"

namespace crest::extremal {

struct OctreeNode {
  bool active = false;
  std::int8_t sign = 1;  ///< of g in the orientation of direction
  Vec3 direction{};
};
/// A minimal edge: no leaf at it is smaller.
struct OctreeEdge {
  Place low;
  std::uint8_t axis;
  int size;
  Index decider;  ///< a leaf that passes the cone test, or kNone
  EdgeState state = EdgeState::untested;
  int depth = 0;
  Vec3 zero{};  ///< of a critical edge, in units of the grid

  auto key() const { return std::pair(low, axis); }
};

class PointTree {
 public:
  PointTree(const PointField& field, int depth);

  const Octree& tree() const { return tree_; }
  const Grid& grid() const { return grid_; }
  const PointField::Box& box(Index leaf) const { return boxes_[leaf]; }
  /// May the surface meet the leaf?
  bool open(Index leaf) const { return boxes_[leaf].near && !boxes_[leaf].nonzero; }
  const std::vector<OctreeEdge>& edges() const { return edges_; }
  /// The place of a minimal edge among edges(), or kNone.
  Index find_edge(Place low, std::size_t axis) const;
  bool is_node(const Node& v) const { return find_node(packed(v)) != kernel::kNone; }
  const OctreeNode& node(const Node& v) const { return nodes_[find_node(packed(v))]; }
  std::size_t count_active() const;
  std::size_t count_nodes() const { return places_.size(); }

  PointField::Sums sums(const Vec3& x) const { return field_.at(grid_.position(x)); }
  /// n . grad s at a place in units of the grid, n on the side of w.
  double oriented(const Vec3& x, const Vec3& w) const;

 private:
  static Grid grid_of(const PointField& field, int depth);
  PointField::Box prove(const OctreeLeaf& leaf, const std::vector<Index>& among) const;
  std::vector<Index> within(const OctreeLeaf& leaf) const {
    const auto [centre, half] = placed(leaf);
    return field_.within(centre, half);
  }
  /// Centre and half the edges.
  std::pair<Vec3, Vec3> placed(const OctreeLeaf& leaf) const;
  bool large(const OctreeLeaf& leaf) const { return leaf.size * grid_.spacing[0] > field_.h() / 4; }
  Content content(const OctreeLeaf& leaf, const PointField::Box& box) const;
  std::vector<Content> find(const std::vector<OctreeLeaf>& boxes);
  bool criteria(const OctreeLeaf& leaf, const PointField::Box& box) const;
  Index find_node(Place p) const;
  void decide_nodes();
  void collect_edges();
  void decide_edge(OctreeEdge& e) const;
  bool follow(const Vec3& a, const Vec3& b, const Vec3& lower, const Vec3& upper, int depth,
              OctreeEdge& e, int& turn) const;

  struct AskedLeaf {
    Place low;
    int size;
    PointField::Box box;
  };

  const PointField& field_;
  Grid grid_;
  std::vector<AskedLeaf> asked_;  ///< what was found to be open; empty once the tree stands
  Octree tree_;
  std::vector<PointField::Box> boxes_;  ///< a leaf's
  std::vector<Place> places_;           ///< nodes, ascending
  std::vector<OctreeNode> nodes_;
  std::vector<OctreeEdge> edges_;  ///< at leaves that the surface may meet, by key
};

}  // namespace crest::extremal
