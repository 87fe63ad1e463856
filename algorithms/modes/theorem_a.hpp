// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one critical point of the mode in a tet that is not degenerate (README.md, theorem A): T* =
// Tbar^2 - tr(Tbar^3) Tbar - I/3 for the unit Tbar, in rationals up to a factor. The surface of
// mode mu has a cone point there iff mu^2 = mu*^2 exactly.
#include <array>
#include <optional>

#include "algorithms/modes/degenerate_result.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::modes {

struct CriticalTensor {
  kernel::Rational squared_mode;  ///< mu*^2 = 1 - mubar^2
  /// T* or -T* strictly inside the tet: barycentric coordinates and the sign of its mode.
  std::optional<std::array<kernel::Rational, 4>> weights;
  int mode_sign = 0;
};

/// Nothing: the corners' deviators are dependent. mubar = +-1: squared_mode is 0, no weights (the
/// critical points of mode 0 are a circle). mubar = 0: squared_mode is 1, T* is degenerate.
std::optional<CriticalTensor> critical_tensor(const std::array<const Tensor*, 4>& corners);

}  // namespace crest::modes
