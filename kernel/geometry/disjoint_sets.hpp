// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A partition of 0 .. n - 1 into sets that only ever join (union-find).
#include <numeric>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::kernel {

/// A set is named by its smallest element, whatever the order of joins.
/// Cost: O(log n) an operation on average over all of them (path halving).
class DisjointSets {
 public:
  explicit DisjointSets(Index n) : parent_(n), count_(n) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index size() const { return static_cast<Index>(parent_.size()); }
  /// How many sets there are.
  Index count() const { return count_; }

  /// The smallest element of x's set.
  Index find(Index x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Joins the sets of a and b; false if they were one already.
  bool unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    (a < b ? parent_[b] : parent_[a]) = a < b ? a : b;
    --count_;
    return true;
  }

 private:
  std::vector<Index> parent_;
  Index count_;
};

}  // namespace crest::kernel
