// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sign of q at a root of p, and which of two roots of quadratics is smaller (formulas, sources
// of coefficients and laws: quadratic_root.hpp). Quadratics of doubles are compiled in
// quadratic_root.cpp; for other sources include kernel/predicates/stages.hpp too.
#include "kernel/predicates/quadratic_root.hpp"

namespace crest::kernel {

/// Climbs several formulas; remembers the highest stage.
class Climber {
 public:
  template <class Formula>
  Sign operator()(const Formula& formula) {
    const Decision d = climb(formula);
    stage_ = std::max(stage_, d.stage);
    return d.sign;
  }
  Decision decision(Sign s) const { return {s, stage_}; }

 private:
  Stage stage_ = Stage::triage;
};

/// The sign of q at the root of p; nothing if p has no real root or is constant.
template <class P, class Q>
std::optional<Decision> sign_at_root(const P& p, QuadraticRoot which, const Q& q) {
  Climber sign;
  const Sign a = sign(QuadraticLeading<P>{p});
  if (a == Sign::zero) {
    if (sign(QuadraticMiddle<P>{p}) == Sign::zero) return std::nullopt;
    return sign.decision(sign(AtLinearRoot<P, Q>{{p, q}}));
  }
  const Sign d = sign(QuadraticDiscriminant<P>{p});
  if (d == Sign::negative) return std::nullopt;
  const Sign u = sign(RootRationalPart<P, Q>{{p, q}});
  if (d == Sign::zero) return sign.decision(u);
  const Sign slope = sign(RootSlope<P, Q>{{p, q}});
  // r = (-b +- sqrt(D)) / (2 a): plus is the larger one iff a > 0.
  const Sign v = (which == QuadraticRoot::larger ? a : -a) * slope;
  if (u == v || v == Sign::zero) return sign.decision(u);
  if (u == Sign::zero) return sign.decision(v);
  return sign.decision(u * a * sign(RootResultant<P, Q>{{p, q}}));
}

/// The sign of (root of p) - (root of q); nothing if either has none.
template <class P, class Q>
std::optional<Decision> root_order(const P& p, QuadraticRoot i, const Q& q, QuadraticRoot k) {
  Climber sign;
  const auto at = sign_at_root(p, i, q);
  if (!at) return std::nullopt;
  const Sign e = sign(QuadraticLeading<Q>{q});
  const auto slope = sign_at_root(p, i, QuadraticSlope<Q>{q});
  const auto result = [&](Sign s) {
    return Decision{s, std::max({at->stage, slope->stage, sign.decision(s).stage})};
  };
  if (e == Sign::zero) {
    const Sign f = sign(QuadraticMiddle<Q>{q});
    if (f == Sign::zero) return std::nullopt;
    return result(at->sign * f);
  }
  if (sign(QuadraticDiscriminant<Q>{q}) == Sign::negative) return std::nullopt;
  // Where q has e's sign, r is beyond both roots on the side its slope tells.
  const Sign height = at->sign * e, side = slope->sign * e;
  const bool smaller = k == QuadraticRoot::smaller;
  if (height == Sign::positive) return result(side);
  if (height == Sign::negative) return result(smaller ? Sign::positive : Sign::negative);
  // r is a root of q: the smaller one iff the slope is negative.
  if (smaller) return result(side == Sign::positive ? Sign::positive : Sign::zero);
  return result(side == Sign::negative ? Sign::negative : Sign::zero);
}

#ifndef CREST_QUADRATIC_ROOT_SOURCE
extern template std::optional<Decision> sign_at_root(const Quadratic&, QuadraticRoot,
                                                     const Quadratic&);
extern template std::optional<Decision> root_order(const Quadratic&, QuadraticRoot,
                                                   const Quadratic&, QuadraticRoot);
#endif

}  // namespace crest::kernel
