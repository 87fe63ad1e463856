// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Expressions over enclosing number types: an expression's constants enclosed, its derivatives by
// jets. Over an enclosing T every coefficient that an evaluator returns encloses the exact one.
#include <cmath>

#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/jet.hpp"
#include "kernel/arithmetic/mp_interval.hpp"
#include "kernel/arithmetic/mp_taylor_model.hpp"
#include "kernel/arithmetic/taylor_lanes.hpp"
#include "kernel/expressions/evaluate.hpp"

namespace crest::kernel {

/// At most one unit in the last place wide; a point where the number has so few bits.
inline MpInterval as_mp_interval(const Constant& c, mpfr_prec_t bits) {
  switch (c.kind) {
    case Constant::Kind::pi:
      return MpInterval::pi(bits);
    case Constant::Kind::e:
      return exp(MpInterval(1.0, bits));
    default:
      return MpInterval::from(c.exact, bits);
  }
}

inline Interval as_interval(const Constant& c) {
  const MpInterval x = as_mp_interval(c, 53);
  return {x.lower(), x.upper()};
}

/// A constant polynomial; the radius bounds |exact - nearest|, and is 0 for a double.
template <int Order>
TaylorModel<Order> as_taylor(const Constant& c) {
  constexpr mpfr_prec_t kBits = 160;
  const MpInterval off = as_mp_interval(c, kBits) - MpInterval(c.nearest, kBits);
  return TaylorModel<Order>::around(c.nearest, std::fmax(-off.lower(), off.upper()));
}

/// A constant as a T: as_enclosure(c, static_cast<const T*>(nullptr)).
inline Interval as_enclosure(const Constant& c, const Interval*) {
  return as_interval(c);
}
template <int Order>
TaylorModel<Order> as_enclosure(const Constant& c, const TaylorModel<Order>*) {
  return as_taylor<Order>(c);
}
template <int Order>
TaylorLanes<Order> as_enclosure(const Constant& c, const TaylorLanes<Order>*) {
  return TaylorLanes<Order>(as_taylor<Order>(c));
}
template <int Order>
MpTaylorModel<Order> as_enclosure(const Constant& c, const MpTaylorModel<Order>*) {
  return MpTaylorModel<Order>(as_mp_interval(c, MpTaylorModel<Order>::kBits));
}
inline double as_enclosure(const Constant& c, const double*) {
  return as_double(c);
}
inline Rational as_enclosure(const Constant& c, const Rational*) {
  return as_rational(c);
}

template <int Variables, int Order>
struct ElementaryFunctions<Jet<Rational, Variables, Order>> {
  using Number = Jet<Rational, Variables, Order>;
  static Number apply(Operation::Code, const Number&) {
    throw std::domain_error("a function of the expression has no rational value");
  }
};

/// The expressions and their derivatives up to JetOrder in `Variables` variables; their arguments
/// are jets, one for each variable that they were parsed with.
/// Throws: std::domain_error for rationals unless they are rational().
template <class T, int Variables, int JetOrder>
Evaluator<Jet<T, Variables, JetOrder>> jet_evaluator(std::span<const Expression> expressions) {
  using Number = Jet<T, Variables, JetOrder>;
  const T* const kind = nullptr;
  const auto convert = [&](const Constant& c) { return Number::constant(as_enclosure(c, kind)); };
  return {expressions, convert, Number::constant(number_like(1, kind))};
}
template <class T, int Variables, int JetOrder>
Evaluator<Jet<T, Variables, JetOrder>> jet_evaluator(const Expression& expression) {
  return jet_evaluator<T, Variables, JetOrder>(std::span(&expression, 1));
}

template <int Order, int Variables, int JetOrder>
Evaluator<Jet<TaylorModel<Order>, Variables, JetOrder>> taylor_jet_evaluator(
    const Expression& expression) {
  return jet_evaluator<TaylorModel<Order>, Variables, JetOrder>(expression);
}

/// Over MPFR intervals of `bits`.
template <int Variables, int JetOrder>
Evaluator<Jet<MpInterval, Variables, JetOrder>> mp_jet_evaluator(const Expression& expression,
                                                                 mpfr_prec_t bits) {
  using Number = Jet<MpInterval, Variables, JetOrder>;
  const auto convert = [&](const Constant& c) { return Number::constant(as_mp_interval(c, bits)); };
  return {expression, convert, Number::constant(MpInterval(1.0, bits))};
}

}  // namespace crest::kernel
