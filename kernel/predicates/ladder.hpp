// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ladder every predicate climbs: triage -> interval -> exact -> symbolic.
//
// A formula is a struct with its inputs, `template <class T> T value() const` written once, and
// `static constexpr int depth` (its rounding depth, re-derived by running value<Depth>()).
// For a predicate x the stages are triage_x (double with the bound of Approximate), interval_x,
// exact_x (rationals), symbolic_x (only where zero must be resolved) and the public x. Where many
// decisions share data on a coarse grid, machine integers may decide them all before the first
// (stage integer, kernel/predicates/critical_value_grid.hpp).
#include <cassert>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/arithmetic/sign.hpp"
#include "kernel/arithmetic/stage.hpp"

namespace crest::kernel {

template <class Formula>
MaybeSign triage(const Formula& formula) {
  return certain_sign(formula.template value<Approximate>(), Formula::depth);
}

/// Out of line (kernel/predicates/stages.hpp), so that hot headers see neither CGAL nor GMP.
template <class Formula>
MaybeSign interval_stage(const Formula& formula);
template <class Formula>
Sign exact_stage(const Formula& formula);

/// Climbs until a stage decides; zero is an answer (Stage::exact).
template <class Formula>
Decision climb(const Formula& formula) {
  if (const MaybeSign s = triage(formula)) {
#ifndef NDEBUG
    // A filter that passes close to its bound is re-run exactly.
    const Approximate a = formula.template value<Approximate>();
    if (std::fabs(a.value) < 100 * (Formula::depth + 2) * kUnitRoundoff * a.magnitude)
      assert(exact_stage(formula) == *s);
#endif
    return {*s, Stage::triage};
  }
  if (const MaybeSign s = interval_stage(formula)) return {*s, Stage::interval};
  return {exact_stage(formula), Stage::exact};
}

}  // namespace crest::kernel
