// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of edges that are given by the numbers of their ends.
#include <algorithm>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::splines {

/// In lists by the later end. Of the edges of a bisection these are short, as most ends of a
/// point's edges came after it; and what is near in space is near in memory.
class EdgeNumbers {
 public:
  /// kNone where the edge has none.
  kernel::Index find(kernel::Index a, kernel::Index b) const {
    const auto [low, high] = std::minmax(a, b);
    if (high >= first_.size()) return kernel::kNone;
    kernel::Index i = first_[high];
    while (i != kernel::kNone && links_[i].low != low) i = links_[i].next;
    return i == kernel::kNone ? i : links_[i].number;
  }

  /// Requires: the edge has none yet.
  void add(kernel::Index a, kernel::Index b, kernel::Index number) {
    const auto [low, high] = std::minmax(a, b);
    if (high >= first_.size())
      first_.resize(std::max<std::size_t>(high + std::size_t{1}, 2 * first_.size()), kernel::kNone);
    links_.push_back({low, number, first_[high]});
    first_[high] = static_cast<kernel::Index>(links_.size() - 1);
  }

 private:
  struct Link {
    kernel::Index low, number, next;
  };
  std::vector<kernel::Index> first_;
  std::vector<Link> links_;
};

}  // namespace crest::splines
