// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From nearly C1 to exactly C1, in integers.
#include "algorithms/splines/cubic_model.hpp"

namespace crest::splines {

/// Rounds f and t to multiples of u, g of 2 u, where u is 2^-46 times the least power of two that
/// is not below any |f|, |g|, |t| (of 0: 1), and lets the last corner or edge of each cube take up
/// what its equations lack; then sets the centres. Guarantees: the numbers satisfy the conditions
/// of C1 exactly, on the whole box; each is less than 2^53 of its units, f, t: u, g: 2 u, f_C: u/8,
/// g_C: u/4. Throws kernel::InputError: numbers too large or too small for that, not finite.
void march_to_c1(CubicModel& model);

}  // namespace crest::splines
