// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A set of numbers below n, each with its rank: an index into what is kept of its members only, at
// a fifth of a byte a number.
#include <bit>
#include <cstdint>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::extremal {

class RankedBits {
 public:
  /// `holds(i)`: is i a member?
  template <class Holds>
  RankedBits(std::size_t n, const Holds& holds) : words_((n + 63) / 64) {
    kernel::Index count = 0;
    for (std::size_t w = 0; w < words_.size(); ++w) {
      words_[w].before = count;
      for (std::size_t i = 64 * w; i < n && i < 64 * w + 64; ++i)
        if (holds(i)) words_[w].bits |= std::uint64_t{1} << (i % 64);
      count += static_cast<kernel::Index>(std::popcount(words_[w].bits));
    }
  }
  RankedBits() = default;

  /// How many members are less than i. Requires: i is one.
  kernel::Index rank(std::size_t i) const {
    const Word& w = words_[i / 64];
    const std::uint64_t below = w.bits & ((std::uint64_t{1} << (i % 64)) - 1);
    return w.before + static_cast<kernel::Index>(std::popcount(below));
  }

 private:
  struct Word {
    std::uint64_t bits = 0;
    kernel::Index before = 0;
  };
  std::vector<Word> words_;
};

}  // namespace crest::extremal
