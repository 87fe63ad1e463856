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

/// What is known around a vertex.
struct Surroundings {
  static constexpr std::size_t kMost = 16;
  std::size_t neighbours = 0, predictions = 0;
  std::array<Index, kMost> neighbour;
  std::array<std::array<Index, 3>, kMost> parallelogram;  ///< prediction: first + second - third
};

Surroundings surroundings(const Surface& surface, const VisitOrder& order, Index v);

}  // namespace crest::coding
