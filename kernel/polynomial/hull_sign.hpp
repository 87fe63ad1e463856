// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the signs of Bernstein coefficients prove about a polynomial on its closed cell. A ladder:
// triage_hull (doubles, one bound for all coefficients), interval_hull, exact_hull, hull.
//
// A formula is a struct with its inputs and `template <class T> SimplexForm<T, ...> value() const`
// (or a box's), written once; T is Bounded<double>, Interval, Rational.
//
// Laws. (1) Negating the form negates the answer (negated()). (2) Raising the degree or halving the
// cell never takes an answer other than mixed away. (3) positive: the polynomial is positive on the
// closed cell. not_negative: on the closed cell at least 0, inside positive.
// Not true: mixed says nothing about the polynomial, which may still have one sign.
#include <optional>

#include "kernel/arithmetic/sign.hpp"
#include "kernel/arithmetic/stage.hpp"
#include "kernel/polynomial/bounded_form.hpp"

namespace crest::kernel {

enum class Hull : std::uint8_t {
  negative,      ///< none positive, all at corners negative
  not_positive,  ///< none positive, not all zero
  zero,          ///< all zero
  not_negative,
  positive,
  mixed  ///< both signs
};
constexpr Hull negated(Hull h) {
  return h == Hull::mixed ? h : static_cast<Hull>(4 - static_cast<int>(h));
}

struct HullDecision {
  Hull hull;
  Stage stage;
};

/// Collects the signs of the coefficients.
class HullSigns {
 public:
  void add(const MaybeSign& s) {
    if (!s)
      ++unknown_;
    else
      ++counts_[static_cast<std::size_t>(static_cast<int>(*s) + 1)];
  }
  void add_corner(const MaybeSign& s) { corner_zero_ = corner_zero_ || s == Sign::zero; }
  /// Nothing: not decided.
  std::optional<Hull> result() const {
    const bool negative = counts_[0] > 0, positive = counts_[2] > 0;
    if (negative && positive) return Hull::mixed;
    if (unknown_ > 0) return std::nullopt;
    if (positive) return corner_zero_ ? Hull::not_negative : Hull::positive;
    if (negative) return corner_zero_ ? Hull::not_positive : Hull::negative;
    return Hull::zero;
  }

 private:
  std::array<std::size_t, 3> counts_{};
  std::size_t unknown_ = 0;
  bool corner_zero_ = false;
};

/// From certain signs of the coefficients of a form over any number type.
template <class T, class B, class SignOf>
std::optional<Hull> hull_of(const Form<T, B>& f, SignOf&& sign) {
  HullSigns signs;
  for (const T& x : f.s) signs.add(sign(x));
  for (std::size_t i = 0; i < B::corners; ++i) signs.add_corner(sign(f.s[B::corner(i)]));
  return signs.result();
}

/// Decides positive, negative and mixed.
template <class B>
std::optional<Hull> certain_hull(const Form<Bounded<double>, B>& f) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < B::count; ++i) {
    // The error's slack covers this product's rounding.
    const double slack = B::weights[i] * f.error;
    low = smaller(low, (f.s[i] > slack) - (f.s[i] < -slack));
    high = larger(high, (f.s[i] > slack) - (f.s[i] < -slack));
  }
  if (low > 0) return Hull::positive;
  if (high < 0) return Hull::negative;
  if (low < 0 && high > 0) return Hull::mixed;
  return std::nullopt;
}

/// Bit i of each: the form of lane i is certainly positive, negative on its closed cell.
struct LaneSigns {
  unsigned positive = 0, negative = 0;
};
template <class B>
LaneSigns certain_signs(const Form<Bounded<Lanes>, B>& f) {
  // Of s - w e and s + w e only the extremes matter. Each is rounded: the error's slack of one part
  // in 2^49 covers w e, and where the difference is not zero its sign is right.
  Lanes low = f.s[0] - Lanes(B::weights[0]) * f.error;
  Lanes high = f.s[0] + Lanes(B::weights[0]) * f.error;
  for (std::size_t i = 1; i < B::count; ++i) {
    const Lanes e = Lanes(B::weights[i]) * f.error;
    low = smaller(low, f.s[i] - e);
    high = larger(high, f.s[i] + e);
  }
  LaneSigns r;
  for (std::size_t i = 0; i < Lanes::count; ++i) {
    const unsigned bit = 1U << i;
    if (low.x[i] > 0) r.positive |= bit;
    if (high.x[i] < 0) r.negative |= bit;
  }
  return r;
}

template <class Formula>
std::optional<Hull> triage_hull(const Formula& formula) {
  return certain_hull(formula.template value<Bounded<double>>());
}
/// Out of line (kernel/polynomial/hull_stages.hpp).
template <class Formula>
std::optional<Hull> interval_hull(const Formula& formula);
template <class Formula>
Hull exact_hull(const Formula& formula);

template <class Formula>
HullDecision hull(const Formula& formula) {
  if (const auto h = triage_hull(formula)) return {*h, Stage::triage};
  if (const auto h = interval_hull(formula)) return {*h, Stage::interval};
  return {exact_hull(formula), Stage::exact};
}

}  // namespace crest::kernel
