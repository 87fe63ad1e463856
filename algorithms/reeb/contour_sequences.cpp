// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/contour_sequences.hpp"

#include <utility>

namespace crest::reeb {

Index ContourSequences::build(Index first, Index last) {
  return build_below(first, last, kRoot);
}

Index ContourSequences::build_below(Index first, Index last, Index parent) {
  if (first == last) return kNone;
  const Index middle = first + (last - first) / 2;
  Node& node = nodes_[middle];
  node.parent = parent;
  node.left = build_below(first, middle, middle);
  node.right = build_below(middle + 1, last, middle);
  return middle;
}

/// Carries a reversal that is pending at x to its children.
void ContourSequences::settle(Index x) {
  Node& node = nodes_[x];
  if ((node.flags & kPending) == 0) return;
  node.flags &= ~kPending;
  for (const Index child : {node.left, node.right}) {
    if (child == kNone) continue;
    std::swap(nodes_[child].left, nodes_[child].right);
    nodes_[child].flags ^= kTurned | kPending;
  }
}

void ContourSequences::reverse(Index root) {
  if (root == kNone) return;
  any_reversed_ = true;
  std::swap(nodes_[root].left, nodes_[root].right);
  nodes_[root].flags ^= kTurned | kPending;
}

void ContourSequences::rotate(Index x) {
  const Index p = nodes_[x].parent, g = nodes_[p].parent;
  Index inner;
  if (nodes_[p].left == x) {
    inner = nodes_[x].right;
    nodes_[p].left = inner;
    nodes_[x].right = p;
  } else {
    inner = nodes_[x].left;
    nodes_[p].right = inner;
    nodes_[x].left = p;
  }
  if (inner != kNone) nodes_[inner].parent = p;
  nodes_[p].parent = x;
  nodes_[x].parent = g;  // with the label, if p was the root
  if ((g & kRoot) != 0) return;
  (nodes_[g].left == p ? nodes_[g].left : nodes_[g].right) = x;
}

void ContourSequences::splay(Index x) {
  if (any_reversed_) {
    path_.clear();
    for (Index y = x;; y = nodes_[y].parent) {
      path_.push_back(y);
      if (is_root(y)) break;
    }
    for (std::size_t i = path_.size(); i-- > 0;) settle(path_[i]);
  }
  while (!is_root(x)) {
    const Index p = nodes_[x].parent;
    if (!is_root(p)) {
      const Index g = nodes_[p].parent;
      rotate((nodes_[g].left == p) == (nodes_[p].left == x) ? p : x);
    }
    rotate(x);
  }
}

std::array<Index, 2> ContourSequences::remove(Index x) {
  settle(x);
  const std::array<Index, 2> parts = {nodes_[x].left, nodes_[x].right};
  for (const Index part : parts)
    if (part != kNone) nodes_[part].parent = kRoot;
  nodes_[x].left = nodes_[x].right = kNone;
  return parts;
}

Index ContourSequences::join(Index a, Index b) {
  if (a == kNone) return b;
  if (b == kNone) return a;
  Index last = a;
  settle(last);
  while (nodes_[last].right != kNone) {
    last = nodes_[last].right;
    settle(last);
  }
  splay(last);
  nodes_[last].right = b;
  nodes_[b].parent = last;
  return last;
}

}  // namespace crest::reeb
