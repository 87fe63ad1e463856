// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An octree over [0, 2^depth]^3 in integers, leaves balanced 2:1 across faces, edges and corners,
// none smaller than what is found in them needs.
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "algorithms/extremal/grid.hpp"

namespace crest::extremal {

/// 20 bits a coordinate.
using Place = std::uint64_t;
inline Place packed(const Node& v) {
  return static_cast<Place>(v[0]) | static_cast<Place>(v[1]) << 20 | static_cast<Place>(v[2]) << 40;
}
inline Node unpacked(Place p) {
  constexpr Place kMask = (Place{1} << 20) - 1;
  return {static_cast<int>(p & kMask), static_cast<int>(p >> 20 & kMask),
          static_cast<int>(p >> 40 & kMask)};
}

inline Node moved(Node v, std::size_t axis, int by) {
  v[axis] += by;
  return v;
}

/// What there is in a box: nothing within reach, nothing, perhaps something, so much that it is to
/// be split.
enum class Content : std::uint8_t { far, empty, open, split };

struct OctreeLeaf {
  Node low;
  int size;
  Content content = Content::open;  ///< as it was found of the leaf or of a box that it is part of
};

class Octree {
 public:
  static constexpr int kDeepest = 19;

  /// Of boxes of one size: the root, or the eight children each of several boxes in turn.
  using Find = std::function<std::vector<Content>(const std::vector<OctreeLeaf>&)>;
  /// Splits boxes as they are found to be, down to size 1; eight that are empty or far become one.
  Octree(int depth, const Find& find);

  const std::vector<OctreeLeaf>& leaves() const { return leaves_; }
  /// The leaf that has the point (x + 1/2) / 2 of the finest grid, x in doubled units; kNone:
  /// outside.
  Index leaf_at(const Node& doubled) const;
  int depth() const { return depth_; }
  /// The least size of a leaf.
  int finest() const;

 private:
  /// Children of a tree's node are eight in a row; 0: a leaf.
  struct TreeNode {
    Index children = 0, leaf = kernel::kNone;
    Content content = Content::open;
  };
  struct Found {
    Index node;
    OctreeLeaf box;
  };
  /// The leaf at a point, or a larger box than size.
  Found find(const Node& doubled, int size) const;
  void split(Index node);
  void merge();
  void balance();
  void number(Index node, const OctreeLeaf& box);
  static OctreeLeaf child(const OctreeLeaf& box, int i) {
    const int half = box.size / 2;
    return {{box.low[0] + (i & 1) * half, box.low[1] + (i >> 1 & 1) * half,
             box.low[2] + (i >> 2) * half},
            half};
  }

  int depth_;
  std::vector<TreeNode> nodes_;
  std::vector<OctreeLeaf> leaves_;
};

}  // namespace crest::extremal
