// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Kind 0: signs of F and of its derivatives on boxes, by intervals (mean values, pieces).
#include <optional>

#include "certify/ridges_smooth/surface.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/mp_interval.hpp"

namespace crest::certify::smooth {

struct Box {
  std::array<double, 3> low, high;
};

/// T: kernel::Interval or kernel::MpInterval. Not for two threads at a time.
template <class T>
class BoxProver {
 public:
  explicit BoxProver(const Surface& surface);

  /// The one sign of F on the box, if it is certain; then F is defined there.
  kernel::MaybeSign value(const Box& box) { return on_pieces(box, nullptr, kDepth); }
  /// The one sign of d . grad F on the box, if it is certain; then F is analytic there.
  kernel::MaybeSign slope(const Box& box, const std::array<double, 3>& d) {
    return on_pieces(box, &d, kDepth);
  }

 private:
  /// Halvings of a box.
  static constexpr int kDepth = 9;
  using Direction = const std::array<double, 3>*;

  kernel::MaybeSign on_pieces(const Box& box, Direction d, int depth);
  kernel::MaybeSign on_box(const Box& box, Direction d);
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
