// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simplices far from all degenerate tensors, by angles at their corners (SPEC.md, lemma 9).
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

  /// Whether all corners lie clearly in the free cone around one of them.
  template <std::size_t n>
  bool free(const std::array<std::uint32_t, n>& corners) const {
    std::uint32_t centre = corners[0];
    for (const auto v : corners)
      if (axes_[v].cosine < axes_[centre].cosine) centre = v;
    const Axis& axis = axes_[centre];
    bool all = true;
    for (const auto v : corners) {
      double sum = 0;
      for (std::size_t k = 0; k < 6; ++k) sum += axis.direction[k] * axes_[v].direction[k];
      all &= v == centre || sum > axis.cosine;
    }
    return all && axis.cosine < 1;
  }

 private:
  struct Axis {
    std::array<double, 6> direction;  ///< not a number where it is not known well
    double cosine;                    ///< with room for all errors; 2: no cone
  };
  std::vector<Axis> axes_;
};

}  // namespace crest::certify::curves
