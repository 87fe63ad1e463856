// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/octree.hpp"

#include <algorithm>

namespace crest::extremal {

Octree::Octree(int depth, const Splits& splits) : depth_(depth), nodes_(1) {
  const OctreeLeaf root = {{0, 0, 0}, 1 << depth};
  std::vector<Index> layer = {0};
  std::vector<OctreeLeaf> boxes = {root};
  while (!layer.empty() && boxes[0].size > 1) {
    const std::vector<bool> split = splits(boxes);
    std::vector<Index> next_layer;
    std::vector<OctreeLeaf> next_boxes;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      if (!split[i]) continue;
      this->split(layer[i]);
      for (int c = 0; c < 8; ++c) {
        next_layer.push_back(nodes_[layer[i]].children + static_cast<Index>(c));
        next_boxes.push_back(child(boxes[i], c));
      }
    }
    layer = std::move(next_layer);
    boxes = std::move(next_boxes);
  }
  balance();
  number(0, root);
}

void Octree::split(Index node) {
  nodes_[node].children = static_cast<Index>(nodes_.size());
  nodes_.resize(nodes_.size() + 8);
}

Octree::Found Octree::find(const Node& doubled) const {
  Found r = {0, {{0, 0, 0}, 1 << depth_}};
  for (const int x : doubled)
    if (x < 0 || x >= 2 << depth_) return {kernel::kNone, r.box};
  while (nodes_[r.node].children != 0) {
    int c = 0;
    for (std::size_t k = 0; k < 3; ++k)
      c |= (doubled[k] >= 2 * r.box.low[k] + r.box.size ? 1 : 0) << k;
    r.node = nodes_[r.node].children + static_cast<Index>(c);
    r.box = child(r.box, c);
  }
  return r;
}

Index Octree::leaf_at(const Node& doubled) const {
  const Found f = find(doubled);
  return f.node == kernel::kNone ? kernel::kNone : nodes_[f.node].leaf;
}

/// Leaves twice as large as a neighbour's double are split, until there are none.
void Octree::balance() {
  std::vector<OctreeLeaf> waiting;
  const std::function<void(Index, const OctreeLeaf&)> collect = [&](Index n,
                                                                    const OctreeLeaf& box) {
    if (nodes_[n].children == 0) {
      waiting.push_back(box);
      return;
    }
    for (int c = 0; c < 8; ++c) collect(nodes_[n].children + static_cast<Index>(c), child(box, c));
  };
  collect(0, {{0, 0, 0}, 1 << depth_});
  while (!waiting.empty()) {
    const OctreeLeaf leaf = waiting.back();
    waiting.pop_back();
    for (int n = 0; n < 27; ++n) {
      if (n == 13) continue;
      const std::array<int, 3> step = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      Node at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = 2 * leaf.low[k] + leaf.size + 2 * leaf.size * step[k];
      for (Found f = find(at); f.node != kernel::kNone && f.box.size > 2 * leaf.size;
           f = find(at)) {
        split(f.node);
        for (int c = 0; c < 8; ++c) waiting.push_back(child(f.box, c));
      }
    }
  }
}

void Octree::number(Index node, const OctreeLeaf& box) {
  if (nodes_[node].children == 0) {
    nodes_[node].leaf = static_cast<Index>(leaves_.size());
    leaves_.push_back(box);
    return;
  }
  for (int c = 0; c < 8; ++c) number(nodes_[node].children + static_cast<Index>(c), child(box, c));
}

int Octree::finest() const {
  int r = 1 << depth_;
  for (const OctreeLeaf& leaf : leaves_) r = std::min(r, leaf.size);
  return r;
}

}  // namespace crest::extremal
