// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of pairs of vertices: a hash table without a list a place, which millions of look-ups
// would wait for.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::modes {

class EdgeTable {
 public:
  using Index = kernel::Index;
  static constexpr Index kNone = ~Index{0};

  /// kNone: the pair has none. Of (a, b) and (b, a) the same.
  Index find(Index a, Index b) const {
    return places_.empty() ? kNone : places_[place_of(key(a, b))].number;
  }
  /// Requires: the pair has none, number is not kNone.
  void add(Index a, Index b, Index number) {
    if (2 * (numbers_.size() + 1) > places_.size()) grow();
    places_[place_of(key(a, b))] = {key(a, b), number};
    numbers_.push_back(number);
  }
  /// In the order in which they were added.
  const std::vector<Index>& numbers() const { return numbers_; }

 private:
  struct Place {
    std::uint64_t key = 0;
    Index number = kNone;
  };
  static std::uint64_t key(Index a, Index b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  /// The key's, or the empty one where it goes.
  std::size_t place_of(std::uint64_t key) const {
    const std::size_t mask = places_.size() - 1;
    std::uint64_t mixed = key * 0x9e3779b97f4a7c15U;
    mixed ^= mixed >> 32;
    std::size_t i = mixed & mask;
    while (places_[i].number != kNone && places_[i].key != key) i = (i + 1) & mask;
    return i;
  }
  void grow() {
    std::vector<Place> old(std::max<std::size_t>(64, 2 * places_.size()));
    old.swap(places_);
    for (const Place& p : old)
      if (p.number != kNone) places_[place_of(p.key)] = p;
  }

  std::vector<Place> places_;  ///< a power of two, at least half of them empty
  std::vector<Index> numbers_;
};

}  // namespace crest::modes
