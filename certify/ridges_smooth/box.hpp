// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Kind 0: signs of F and of its derivatives on boxes, by intervals and mean values (SPEC.md, "How
// it is evaluated").
#include <optional>

#include "certify/ridges_smooth/surface.hpp"
#include "certify/ridges_smooth/witness.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/mp_interval.hpp"

namespace crest::certify::smooth {

struct Box {
  std::array<double, 3> low, high;

  /// The halves of a split across an axis; nothing if there is no double between.
  std::optional<std::array<Box, 2>> split(std::size_t axis) const;
};

/// T: kernel::Interval or kernel::MpInterval. Not for two threads at a time.
template <class T>
class BoxProver {
 public:
  explicit BoxProver(const Surface& surface);

  /// Null: the quantity is F itself, else d . grad F.
  using Direction = const std::array<double, 3>*;
  /// The one sign of the quantity on the box, if it is certain; then F is defined there, analytic
  /// if there is a direction.
  kernel::MaybeSign on_box(const Box& box, Direction d);
  /// On the pieces that a witness divides the box into. Throws Undecided.
  kernel::Sign on_pieces(const Box& box, Direction d, WitnessReader& in, int depth = 0);

 private:
  static constexpr int kDepth = 16;

  template <int n>
  kernel::MaybeSign natural_or_mean(const Box& box, Direction d);
  template <int n>
  auto& evaluator() {
    if constexpr (n == 1)
      return first_;
    else
      return second_;
  }

  kernel::Evaluator<kernel::Jet<T, 3, 1>> first_;
  kernel::Evaluator<kernel::Jet<T, 3, 2>> second_;
};

}  // namespace crest::certify::smooth
