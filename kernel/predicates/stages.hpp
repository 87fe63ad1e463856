// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The interval and exact stages, for the predicates' own .cpp files only: it pulls in CGAL and GMP.
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

template <class Formula>
MaybeSign interval_stage(const Formula& formula) {
  RoundUpward guard;
  return certain_sign(formula.template value<Interval>());
}

template <class Formula>
Sign exact_stage(const Formula& formula) {
  return sign_of(formula.template value<Rational>());
}

/// Compiles both stages of a formula in this file.
#define CREST_INSTANTIATE_STAGES(Formula)                     \
  template MaybeSign interval_stage<Formula>(const Formula&); \
  template Sign exact_stage<Formula>(const Formula&);

}  // namespace crest::kernel
