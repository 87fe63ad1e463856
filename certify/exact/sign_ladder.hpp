// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exact signs of polynomials in the data: double with a derived bound, then guarded intervals,
// then rationals; or MPFR intervals, then rationals.
#include <cstdint>

#include "certify/container/verdict.hpp"
#include "certify/exact/filtered.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/mp_interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify {

/// Decides formulas, each a generic callable f(lift) that lifts its doubles with `lift` and returns
/// a number; it is the same text in every stage. Cost: 10 ns in doubles, 0.1 ms in rationals.
class SignLadder {
 public:
  explicit SignLadder(Arithmetic arithmetic) : arithmetic_(arithmetic) {}

  template <class Formula>
  kernel::Sign operator()(const Formula& formula) {
    ++counts_.calls;
    if (arithmetic_ == Arithmetic::doubles) {
      if (const auto sign = certify::certain_sign(formula([](double x) { return filtered(x); })))
        return *sign;
    }
    return climb(formula);
  }

  /// For formulas with sums of any length, which the first stage's numbers cannot carry.
  template <class Formula>
  kernel::Sign without_triage(const Formula& formula) {
    ++counts_.calls;
    return climb(formula);
  }

  /// The first stage alone, for a number that several decisions share. Empty with mpfr.
  template <int N>
  kernel::MaybeSign triage(const Filtered<N>& x) {
    if (arithmetic_ != Arithmetic::doubles) return std::nullopt;
    const auto sign = certify::certain_sign(x);
    counts_.calls += sign.has_value();
    return sign;
  }

  const SignCounts& counts() const { return counts_; }

 private:
  template <class Formula>
  kernel::Sign climb(const Formula& formula) {
    ++counts_.interval;
    if (const auto sign =
            arithmetic_ == Arithmetic::doubles ? by_interval(formula) : by_mpfr(formula))
      return *sign;
    ++counts_.exact;
    return kernel::sign_of(formula([](double x) { return kernel::Rational(x); }));
  }
  template <class Formula>
  static kernel::MaybeSign by_mpfr(const Formula& formula) {
    return certain_sign(formula([](double x) { return kernel::MpInterval(x, 128); }));
  }
  template <class Formula>
  static kernel::MaybeSign by_interval(const Formula& formula) {
    const kernel::RoundUpward guard;
    return kernel::certain_sign(formula([](double x) { return kernel::Interval(x); }));
  }

  Arithmetic arithmetic_;
  SignCounts counts_;
};

}  // namespace crest::certify
