// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is proven of simplices (D = 2 faces, 3 cells) of a level's trees: f has one sign on one, or
// there is a direction along which the mode grows wherever f = 0 (README.md, H4 and the lemma).
// Eight go through the formulas together (kernel/arithmetic/lanes.hpp), each as it would alone.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "algorithms/modes/level.hpp"
#include "algorithms/modes/tensors.hpp"
#include "kernel/arithmetic/lanes.hpp"

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

/// How many simplices are tested together.
inline constexpr std::size_t kTogether = kernel::Lanes::count;

template <int D>
using Corners = std::array<const Deviator*, D + 1>;

/// Simplex i's tensors, exactly, with one exponent for all.
template <int D>
using ExactCorners = std::function<std::array<Entries<kernel::Integer>, D + 1>(std::size_t i)>;

/// Requires: at most kTogether simplices, at least one; no corner's tensor is zero; finite entries,
/// below 2^100. Pure, if `exact` is.
template <int D>
void test_cells(std::span<const Corners<D>> cells, const ExactCorners<D>& exact, const Level& level,
                std::span<CellResult<D>> results);
extern template void test_cells<2>(std::span<const Corners<2>>, const ExactCorners<2>&,
                                   const Level&, std::span<CellResult<2>>);
extern template void test_cells<3>(std::span<const Corners<3>>, const ExactCorners<3>&,
                                   const Level&, std::span<CellResult<3>>);

/// The sign alone: positive, uniform, negative, none (both signs, or not known).
struct CellSign {
  Finding finding = Finding::none;
  bool bound = false;  ///< the sizes of det and |T|^2 were enough
};
/// Requires, pure: as test_cells.
void cell_signs(std::span<const Corners<3>> cells, const ExactCorners<3>& exact, const Level& level,
                std::span<CellSign> results);

}  // namespace crest::modes
