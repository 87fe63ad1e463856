// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which of two nodes comes first: by value, equal values by number (certify/SPEC.md, claim 3,
// "Nodes"). Values are fractions whose denominator's sign is known, so no division is needed.
//
// The function itself is not perturbed: only the order of the tiles' nodes is, so one input has one
// answer whatever its plateaus, and every stage before the last speaks about the input.
//
// Laws. (1) antisymmetric: order(x, y) = -order(y, x). (2) transitive, never zero for different
// numbers. (3) a line-critical value does not depend on the edge's direction, a face-critical one
// not on the corners' order. (4) a line-critical value compares to its edge's ends as its kind
// says. (5) negating all values reverses the comparison where it is not a tie.
#include "kernel/predicates/critical_value.hpp"

namespace crest::kernel {

/// value(x) - value(y) times the product of both denominators.
template <ValueKind x_kind, ValueKind y_kind>
struct ValueDifference {
  FaceValues x, y;
  static constexpr int numerator_depth(ValueKind k) {
    return k == ValueKind::vertex ? 0 : k == ValueKind::edge ? 11 : 16;
  }
  static constexpr int denominator_depth(ValueKind k) {
    return k == ValueKind::vertex ? 0 : k == ValueKind::edge ? 4 : 9;
  }
  static constexpr int larger(int a, int b) { return a < b ? b : a; }
  /// (x0 - y0) dx dy + (nx dy - ny dx), derived by value<Depth>().
  static constexpr int depth =
      1 + larger(1 + denominator_depth(x_kind) + 2 + denominator_depth(y_kind) + 2,
                 1 + larger(numerator_depth(x_kind) + denominator_depth(y_kind) + 2,
                            numerator_depth(y_kind) + denominator_depth(x_kind) + 2));

  template <class T>
  T value() const {
    const ValueFraction<T, x_kind> a(x);
    const ValueFraction<T, y_kind> b(y);
    return (T(x.corner[0]) - T(y.corner[0])) * a.denominator * b.denominator +
           (a.numerator * b.denominator - b.numerator * a.denominator);
  }
};

/// The sign of value(x) - value(y). Triage finds zero for two vertices and for data that
/// are equal up to the order of the corners.
MaybeSign triage_critical_value_order(const CriticalValue& x, const CriticalValue& y);
MaybeSign interval_critical_value_order(const CriticalValue& x, const CriticalValue& y);
Sign exact_critical_value_order(const CriticalValue& x, const CriticalValue& y);
/// The tie: negative iff x has the smaller number.
inline Sign symbolic_critical_value_order(std::uint32_t x, std::uint32_t y) {
  return x < y ? Sign::negative : x > y ? Sign::positive : Sign::zero;
}

/// The sign of value(x) - value(y); zero is an answer.
Decision compare_critical_values(const CriticalValue& x, const CriticalValue& y);

/// negative: x comes first, positive: y. stage symbolic iff the values are equal.
/// Requires: different numbers.
inline Decision critical_value_order(const CriticalValue& x, std::uint32_t x_number,
                                     const CriticalValue& y, std::uint32_t y_number) {
  const Decision d = compare_critical_values(x, y);
  if (d.sign != Sign::zero) return d;
  return {symbolic_critical_value_order(x_number, y_number), Stage::symbolic};
}

}  // namespace crest::kernel
