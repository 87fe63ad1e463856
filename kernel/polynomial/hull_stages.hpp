// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The interval and exact stages of hull signs, for the .cpp files that instantiate formulas: it
// pulls in CGAL and GMP, and such files are compiled with -frounding-math.
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/polynomial/hull_sign.hpp"

namespace crest::kernel {

template <class Formula>
std::optional<Hull> interval_hull(const Formula& formula) {
  RoundUpward guard;
  return hull_of(formula.template value<Interval>(),
                 [](const Interval& x) { return certain_sign(x); });
}

template <class Formula>
Hull exact_hull(const Formula& formula) {
  return *hull_of(formula.template value<Rational>(),
                  [](const Rational& x) -> MaybeSign { return sign_of(x); });
}

/// Compiles both stages of a formula in this file.
#define CREST_INSTANTIATE_HULL(Formula)                                \
  template std::optional<Hull> interval_hull<Formula>(const Formula&); \
  template Hull exact_hull<Formula>(const Formula&);

}  // namespace crest::kernel
