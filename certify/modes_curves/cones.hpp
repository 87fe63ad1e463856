// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simplices far from all degenerate tensors, by angles at their corners (SPEC.md, lemma 11).
#include <array>
#include <span>
#include <vector>

#include "certify/exact/tensor_field.hpp"

namespace crest::certify::curves {

/// Directions of the deviators at the vertices, and the cosines of their angles to the nearest
/// degenerate tensors.
class Cones {
 public:
  explicit Cones(const modes::Field& field);

  /// Whether all corners lie clearly in the free cone around one of them, or around their mean.
  template <std::size_t n>
  bool free(const std::array<std::uint32_t, n>& corners) const {
    Axis mean{};
    std::uint32_t best = corners[0];
    for (const auto v : corners) {
      if (axes_[v].cosine < axes_[best].cosine) best = v;
      for (std::size_t k = 0; k < 6; ++k) mean.direction[k] += axes_[v].direction[k];
    }
    if (holds(axes_[best], corners)) return true;
    normalise(mean);
    return holds(mean, corners);
  }

 private:
  struct Axis {
    std::array<double, 6> direction;  ///< not a number where it is not known well
    double cosine;                    ///< with room for all errors; 2: no cone
  };
  /// Makes the direction one, and finds the cosine.
  static void normalise(Axis& axis);
  template <std::size_t n>
  bool holds(const Axis& axis, const std::array<std::uint32_t, n>& corners) const {
    bool all = true;
    for (const auto v : corners) {
      double sum = 0;
      for (std::size_t k = 0; k < 6; ++k) sum += axis.direction[k] * axes_[v].direction[k];
      all &= sum > axis.cosine;
    }
    return all;
  }

  std::vector<Axis> axes_;
};

}  // namespace crest::certify::curves
