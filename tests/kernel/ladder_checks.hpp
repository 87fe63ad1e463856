// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What every formula of the ladder must satisfy, run over the degenerate families.
#include <catch2/catch.hpp>

#include "kernel/predicates/stages.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/failures.hpp"

namespace crest::tests {

/// Draws `calls` inputs and requires that no stage contradicts a later one: triage and interval
/// against each other always, against the rationals when they do not decide and on every 16th call.
/// Returns who decided. Failures are counted, the first one shown: a Catch assertion a call costs
/// more than the predicate.
template <class Formula, class Make>
kernel::StageCounts require_stages_agree(std::uint64_t calls, Make&& make) {
  kernel::StageCounts counts;
  Failures failures;
  for (std::uint64_t i = 0; i < calls; ++i) {
    const Formula formula = make(i);
    const kernel::MaybeSign fast = kernel::triage(formula);
    const kernel::MaybeSign interval = kernel::interval_stage(formula);
    if (fast && interval)
      failures.expect(*fast == *interval, "triage is as the interval stage on", formula);
    if (!fast || !interval || i % 16 == 0) {
      const kernel::Sign exact = kernel::exact_stage(formula);
      if (fast) failures.expect(*fast == exact, "triage is as the exact stage on", formula);
      if (interval)
        failures.expect(*interval == exact, "the interval stage is as the exact one on", formula);
    }
    counts.add(fast       ? kernel::Stage::triage
               : interval ? kernel::Stage::interval
                          : kernel::Stage::exact);
  }
  CHECK(failures.report() == "");
  return counts;
}

/// The constant in the header is what the template says.
template <class Formula>
void require_depth(const Formula& formula) {
  CHECK(Formula::depth == formula.template value<kernel::Depth>().count);
}

/// |value - exact| <= (depth + 2) u magnitude, in rationals.
template <class Formula>
bool bound_holds(const Formula& formula) {
  using kernel::Rational;
  const kernel::Approximate a = formula.template value<kernel::Approximate>();
  if (!std::isfinite(a.magnitude)) return true;
  const Rational error = Rational(a.value) - formula.template value<Rational>();
  const Rational bound =
      Rational((Formula::depth + 2) * kernel::kUnitRoundoff) * Rational(a.magnitude);
  return abs(error) <= bound;
}

/// The same for `cases` drawn formulas, required.
template <class Make>
void require_bound(std::uint64_t cases, Make&& make) {
  Failures failures;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const auto formula = make();
    failures.expect(bound_holds(formula), "the error bound holds on", formula);
  }
  CHECK(failures.report() == "");
}

}  // namespace crest::tests
