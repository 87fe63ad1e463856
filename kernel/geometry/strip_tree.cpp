// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/strip_tree.hpp"

#include <algorithm>
#include <cstdint>

namespace crest::kernel {
namespace {

class Conquest {
 public:
  Conquest(const CornerTable& table, std::span<const Triangle> faces, StripExits exits)
      : table_(table), faces_(faces), exits_(exits) {
    met_.assign(table.vertex_count(), 0);
    done_.assign(faces.size(), 0);
    for (Index h = 0; h < 3 * table.face_count(); ++h)
      if (table.opposite(h) == kNone) met_[from(h)] = 1;
    tree_.entered.reserve(faces.size());
  }

  bool done(Index f) const { return done_[f] != 0; }
  void conquer_component(Index gate) {
    tree_.removed.push_back(table_.opposite(gate));
    met_[from(gate)] = met_[from(next_half(gate))] = 1;
    if (const Index across = table_.opposite(gate); across != kNone) {
      done_[across / 3] = 1;
      met_[from(previous_half(across))] = 1;
    }
    tree_.roots.push_back(grow(gate));
    add_children(tree_.roots.back());
    while (!waiting_.empty()) {
      const Child child = waiting_.back();
      waiting_.pop_back();
      if (done(child.gate / 3)) {
        tree_.nodes[child.parent].split = child.gate;
        continue;
      }
      const Index node = grow(child.gate);
      (child.left ? tree_.nodes[child.parent].left : tree_.nodes[child.parent].right) = node;
      add_children(node);
    }
  }
  StripTree take() { return std::move(tree_); }

 private:
  struct Child {
    Index parent, gate;
    bool left;
  };
  Index from(Index h) const { return faces_[h / 3][h % 3]; }

  Index grow(Index h) {
    const auto begin = static_cast<Index>(tree_.entered.size());
    for (bool left = true;; left = exits_ == StripExits::fan || !left) {
      tree_.entered.push_back(h);
      done_[h / 3] = 1;
      std::uint8_t& tip = met_[from(previous_half(h))];
      if (tip) break;
      tip = 1;
      h = table_.opposite(left ? next_half(h) : previous_half(h));
    }
    const auto length = static_cast<Index>(tree_.entered.size()) - begin;
    tree_.nodes.push_back({begin, length, kNone, kNone, kNone});
    return static_cast<Index>(tree_.nodes.size() - 1);
  }
  void add_children(Index node) {
    const Index last = tree_.entered.back();
    for (const bool left : {false, true}) {
      const Index gate = table_.opposite(left ? next_half(last) : previous_half(last));
      if (gate != kNone && !done(gate / 3)) waiting_.push_back({node, gate, left});
    }
  }

  const CornerTable& table_;
  std::span<const Triangle> faces_;
  StripExits exits_;
  std::vector<std::uint8_t> met_, done_;
  std::vector<Child> waiting_;
  StripTree tree_;
};

/// The first half-edge of each component, on the boundary if it has one.
std::vector<Index> first_gates(const CornerTable& table) {
  std::vector<Index> gates, waiting;
  std::vector<std::uint8_t> seen(table.face_count(), 0);
  for (Index first = 0; first < table.face_count(); ++first) {
    if (seen[first]) continue;
    Index gate = kNone;
    seen[first] = 1;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const Index f = waiting.back();
      waiting.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index across = table.opposite(h);
        if (across == kNone) {
          gate = std::min(gate, h);
        } else if (!seen[across / 3]) {
          seen[across / 3] = 1;
          waiting.push_back(across / 3);
        }
      }
    }
    gates.push_back(gate == kNone ? 3 * first : gate);
  }
  return gates;
}

}  // namespace

StripTree grow_strips(const CornerTable& table, std::span<const Triangle> faces, StripExits exits,
                      std::span<const Index> gates) {
  Conquest conquest(table, faces, exits);
  const std::vector<Index> own = gates.empty() ? first_gates(table) : std::vector<Index>{};
  for (const Index gate : gates.empty() ? std::span<const Index>(own) : gates)
    conquest.conquer_component(gate);
  return conquest.take();
}

std::vector<Index> postorder(const StripTree& tree) {
  // Node, right, left is the mirror image's preorder: turned around it is left, right, node.
  std::vector<Index> order, waiting;
  order.reserve(tree.nodes.size());
  for (const Index root : tree.roots) {
    const std::size_t begin = order.size();
    waiting.push_back(root);
    while (!waiting.empty()) {
      const Index node = waiting.back();
      waiting.pop_back();
      order.push_back(node);
      if (tree.nodes[node].left != kNone) waiting.push_back(tree.nodes[node].left);
      if (tree.nodes[node].right != kNone) waiting.push_back(tree.nodes[node].right);
    }
    std::reverse(order.begin() + static_cast<std::ptrdiff_t>(begin), order.end());
  }
  return order;
}

}  // namespace crest::kernel
