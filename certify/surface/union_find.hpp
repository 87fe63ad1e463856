// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Classes of numbers below n.
#include <cstdint>
#include <numeric>
#include <vector>

namespace crest::certify {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The smaller representative stays. True if they were two classes.
  bool join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i < j)
      parent_[j] = i;
    else
      parent_[i] = j;
    return i != j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace crest::certify
