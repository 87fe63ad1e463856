// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Boxes in the plane, and which of many meet one: only to find candidates.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace crest::certify {

/// Closed; what it bounds is inside.
struct PlaneBox {
  std::array<double, 2> low = {std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity()};
  std::array<double, 2> high = {-std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};

  void add(const PlaneBox& other) {
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  bool meets(const PlaneBox& other) const {
    for (std::size_t k = 0; k < 2; ++k)
      if (other.high[k] < low[k] || high[k] < other.low[k]) return false;
    return true;
  }
};

/// A balanced tree over boxes, halved by their middles along the longer side in turns.
class BoxTree {
 public:
  explicit BoxTree(std::vector<PlaneBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, order_.size(), 0);
  }

  /// Calls visit(i) for every box i that meets `box`, in an order that depends on the boxes alone.
  template <class Visit>
  void query(const PlaneBox& box, Visit&& visit) const {
    if (!boxes_.empty()) query(box, visit, 0, 0, order_.size());
  }

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Node {
    PlaneBox box;
    std::uint32_t right = 0;  // 0: a leaf
  };

  std::uint32_t build(std::size_t first, std::size_t last, std::size_t axis) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    PlaneBox bound;
    for (std::size_t i = first; i < last; ++i) bound.add(boxes_[order_[i]]);
    nodes_[node].box = bound;
    if (last - first <= kLeaf) return node;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t i, std::uint32_t j) {
      const double x = boxes_[i].low[axis], y = boxes_[j].low[axis];
      return x < y || (x == y && i < j);
    });
    build(first, middle, 1 - axis);
    nodes_[node].right = build(middle, last, 1 - axis);
    return node;
  }

  template <class Visit>
  void query(const PlaneBox& box, Visit& visit, std::uint32_t node, std::size_t first,
             std::size_t last) const {
    if (!nodes_[node].box.meets(box)) return;
    if (nodes_[node].right == 0) {
      for (std::size_t i = first; i < last; ++i)
        if (boxes_[order_[i]].meets(box)) visit(order_[i]);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    query(box, visit, node + 1, first, middle);
    query(box, visit, nodes_[node].right, middle, last);
  }

  std::vector<PlaneBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace crest::certify
