// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// In which order positions are coded, and from what they are predicted; both depend on connectivity
// alone (docs/cmc-format.md, "Positions").
#include <algorithm>
#include <array>
#include <vector>

#include "algorithms/coding/surface.hpp"

namespace crest::coding {

/// In which order vertices come: of those with the most parallelograms whose other three vertices
/// are known, the one that got this many first; without any, a known vertex's neighbour; else the
/// lowest.
class VisitOrder {
 public:
  explicit VisitOrder(const Surface& surface)
      : surface_(surface),
        known_(surface.counts().vertices, 0),
        count_(known_.size(), 0),
        queued_(known_.size(), 0) {}

  bool known(Index v) const { return known_[v] != 0; }
  /// The next vertex, or kNone.
  Index take();
  void visit(Index w);

 private:
  static constexpr std::size_t kMost = 15;
  struct Queue {
    std::vector<Index> entries;
    std::size_t head = 0;
  };
  void credit(Index v) {
    if (count_[v] < kMost) queues_[++count_[v]].entries.push_back(v);
    highest_ = std::max<std::size_t>(highest_, count_[v]);
  }

  const Surface& surface_;
  std::vector<std::uint8_t> known_, count_, queued_;
  std::array<Queue, kMost + 1> queues_;
  std::size_t highest_ = 0;
  Index lowest_ = 0;
};

/// What is known around an item: a vertex, or a wedge of corners at one.
struct Surroundings {
  static constexpr std::size_t kMost = 16;
  std::size_t neighbours = 0, predictions = 0;
  std::array<Index, kMost> neighbour;
  std::array<std::array<Index, 3>, kMost> parallelogram;  ///< prediction: first + second - third

  void add_neighbour(Index item) {
    if (neighbours < kMost) neighbour[neighbours++] = item;
  }
};

/// `each_corner` calls its argument with the item's corners, as half-edges that start there, in
/// turn; item_of() tells of such a half-edge the item, known() of an item whether it is coded.
template <class EachCorner, class ItemOf, class Known>
Surroundings surroundings(const Surface& surface, EachCorner&& each_corner, ItemOf&& item_of,
                          Known&& known) {
  Surroundings s;
  each_corner([&](Index h) {
    const Index next = next_half(h), last = previous_half(h);
    const Index a = item_of(next), b = item_of(last), beside = surface.twin(last);
    const bool knows_a = known(a), knows_b = known(b);
    if (knows_a) s.add_neighbour(a);
    // The end of an item's corners: no other one of them has b.
    if (knows_b && (beside == kNone || item_of(beside) != item_of(h))) s.add_neighbour(b);
    const Index across = surface.twin(next);
    if (!knows_a || !knows_b || across == kNone || s.predictions == Surroundings::kMost) return;
    const Index d = item_of(previous_half(across));
    if (known(d) && item_of(across) == b && item_of(next_half(across)) == a)
      s.parallelogram[s.predictions++] = {a, b, d};
  });
  return s;
}

}  // namespace crest::coding
