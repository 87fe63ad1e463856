// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pairs of numbers, whichever comes first.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::io {

/// A hash table of its own: millions of edges, a dozen bytes each.
class EdgeSet {
 public:
  bool has(kernel::Index a, kernel::Index b) const {
    return !table_.empty() && table_[place(key(a, b))] != kEmpty;
  }
  void insert(kernel::Index a, kernel::Index b) {
    if (2 * (size_ + 1) > table_.size()) grow();
    std::uint64_t& entry = table_[place(key(a, b))];
    size_ += entry == kEmpty;
    entry = key(a, b);
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

  static std::uint64_t key(kernel::Index a, kernel::Index b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  /// Where the key is, or would be.
  std::size_t place(std::uint64_t key) const {
    std::size_t at = (key * 0x9e3779b97f4a7c15u) >> shift_;
    while (table_[at] != kEmpty && table_[at] != key) at = (at + 1) & (table_.size() - 1);
    return at;
  }
  void grow() {
    std::vector<std::uint64_t> old = std::move(table_);
    table_.assign(std::max<std::size_t>(64, 2 * old.size()), kEmpty);
    shift_ = 64;
    for (std::size_t n = table_.size(); n > 1; n /= 2) --shift_;
    for (const std::uint64_t key : old)
      if (key != kEmpty) table_[place(key)] = key;
  }

  std::vector<std::uint64_t> table_;
  std::size_t size_ = 0;
  int shift_ = 64;
};

}  // namespace crest::io
