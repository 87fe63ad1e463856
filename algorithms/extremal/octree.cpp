// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/octree.hpp"

#include <algorithm>

namespace crest::extremal {

Octree::Octree(int depth, const Find& find) : depth_(depth), nodes_(1) {
  const OctreeLeaf root = {{0, 0, 0}, 1 << depth};
  std::vector<Index> layer = {0};
  std::vector<OctreeLeaf> boxes = {root};
  while (!layer.empty()) {
    const std::vector<Content> found = find(boxes);
    std::vector<Index> next_layer;
    std::vector<OctreeLeaf> next_boxes;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      const bool splits = found[i] == Content::split && boxes[i].size > 1;
      nodes_[layer[i]].content = splits || found[i] != Content::split ? found[i] : Content::open;
      if (!splits) continue;
      split(layer[i]);
      for (int c = 0; c < 8; ++c) {
        next_layer.push_back(nodes_[layer[i]].children + static_cast<Index>(c));
        next_boxes.push_back(child(boxes[i], c));
      }
    }
    layer = std::move(next_layer);
    boxes = std::move(next_boxes);
  }
  merge();
  balance();
  number(0, root);
}

void Octree::split(Index node) {
  nodes_[node].children = static_cast<Index>(nodes_.size());
  TreeNode part;
  part.content = nodes_[node].content;
  nodes_.resize(nodes_.size() + 8, part);
}

/// Children stand behind their box.
void Octree::merge() {
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    TreeNode& box = nodes_[n];
    if (box.children == 0) continue;
    const auto first = nodes_.begin() + box.children;
    const Content most =
        std::max_element(first, first + 8, [](const TreeNode& a, const TreeNode& b) {
          return a.content < b.content;
        })->content;
    if (most > Content::empty) continue;
    box.children = 0;
    box.content = most;
  }
}

Octree::Found Octree::find(const Node& doubled, int size) const {
  Found r = {0, {{0, 0, 0}, 1 << depth_}};
  for (const int x : doubled)
    if (x < 0 || x >= 2 << depth_) return {kernel::kNone, r.box};
  while (nodes_[r.node].children != 0 && r.box.size > size) {
    int c = 0;
    for (std::size_t k = 0; k < 3; ++k)
      c |= (doubled[k] >= 2 * r.box.low[k] + r.box.size ? 1 : 0) << k;
    r.node = nodes_[r.node].children + static_cast<Index>(c);
    r.box = child(r.box, c);
  }
  return r;
}

Index Octree::leaf_at(const Node& doubled) const {
  const Found f = find(doubled, 0);
  return f.node == kernel::kNone ? kernel::kNone : nodes_[f.node].leaf;
}

/// Round a box that is split there are boxes of its size: leaves that are larger are split.
void Octree::balance() {
  std::vector<OctreeLeaf> waiting;
  const std::function<void(Index, const OctreeLeaf&)> collect = [&](Index n,
                                                                    const OctreeLeaf& box) {
    if (nodes_[n].children == 0) return;
    waiting.push_back(box);
    for (int c = 0; c < 8; ++c) collect(nodes_[n].children + static_cast<Index>(c), child(box, c));
  };
  collect(0, {{0, 0, 0}, 1 << depth_});
  while (!waiting.empty()) {
    const OctreeLeaf box = waiting.back();
    waiting.pop_back();
    for (int n = 0; n < 27; ++n) {
      const std::array<int, 3> step = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      Node at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = 2 * box.low[k] + box.size + 2 * box.size * step[k];
      for (Found f = find(at, box.size); f.node != kernel::kNone && f.box.size > box.size;
           f = find(at, box.size)) {
        split(f.node);
        waiting.push_back(f.box);
      }
    }
  }
}

void Octree::number(Index node, const OctreeLeaf& box) {
  if (nodes_[node].children == 0) {
    nodes_[node].leaf = static_cast<Index>(leaves_.size());
    leaves_.push_back({box.low, box.size, nodes_[node].content});
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
