// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mode in plain doubles: for positions, which no decision rests on.
#include <cmath>

#include "algorithms/modes/level.hpp"
#include "algorithms/modes/tensors.hpp"

namespace crest::modes {

class ModeFunction {
 public:
  ModeFunction(const Level& level, Side side)
      : m_(static_cast<double>(static_cast<int>(side)) * level.value()) {}
  /// Positive above the level, continuous.
  double height(const Symmetric& t) const {
    const double n = product(t, t), c = product(anticommutator(t, t), t);
    return 0.5 * std::sqrt(6.0) * c - m_ * n * std::sqrt(n);
  }
  static double mode(const Symmetric& t) {
    const double n = product(t, t), c = product(anticommutator(t, t), t);
    return 0.5 * std::sqrt(6.0) * c / (n * std::sqrt(n));
  }

 private:
  double m_;
};

}  // namespace crest::modes
