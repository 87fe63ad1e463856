// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is proven of one simplex (D = 2 a face, 3 a cell) of a level's trees: f has one sign on it,
// or a direction along which the mode grows wherever f = 0 (README.md, H4 and the lemma).
#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "algorithms/modes/level.hpp"
#include "algorithms/modes/tensors.hpp"

namespace crest::modes {

/// (w, lambda) in the simplex's own barycentrics: w_0 = -(w_1 + .. + w_D), the tensors as they are
/// scaled here.
template <int D>
struct Witness {
  std::array<std::int16_t, D + 1> w{};
  std::int16_t lambda = 0;
};

enum class Finding : std::uint8_t {
  positive,  ///< f >= 0, not identically
  uniform,   ///< f = 0 everywhere
  negative,  ///< f < 0
  graph,     ///< the witness holds
  none
};

template <int D>
struct CellResult {
  Finding finding = Finding::none;
  Witness<D> witness{};
  bool exact = false;  ///< integers decided
};

/// The corners' tensors, exactly, with one exponent for all.
template <int D>
using ExactCorners = std::function<std::array<Entries<kernel::Integer>, D + 1>()>;

/// Requires: no corner's tensor is zero; finite entries, below 2^100.
template <int D>
CellResult<D> test_cell(const std::array<Tensor, D + 1>& corners, const ExactCorners<D>& exact,
                        const Level& level);
/// The sign alone, as far as doubles tell: positive, negative, none (both signs), or not decided.
/// `bound`: the sizes of det and |T|^2 were enough. Pure: for parallel loops.
std::optional<Finding> certain_cell_sign(const std::array<Tensor, 4>& corners, const Level& level,
                                         bool& bound);
/// The sign alone: no witness is looked for.
Finding cell_sign(const std::array<Tensor, 4>& corners, const ExactCorners<3>& exact,
                  const Level& level);
extern template CellResult<2> test_cell<2>(const std::array<Tensor, 3>&, const ExactCorners<2>&,
                                           const Level&);
extern template CellResult<3> test_cell<3>(const std::array<Tensor, 4>&, const ExactCorners<3>&,
                                           const Level&);

}  // namespace crest::modes
