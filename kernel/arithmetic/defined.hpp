// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a number is certainly defined and finite.
//
// Law of every enclosing type (intervals, Taylor models, both over MPFR too, and jets over them):
// undefined is a poison. No operation gives a defined result of an undefined operand: not zero
// times it, not its power zero, not its sine, not its difference to itself, not a coefficient that
// is skipped. So a defined value of an expression proves that all its parts are defined.
#include <cmath>

#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {

// Every number type has its own, found by its namespace; there is no default to fall back on.
inline bool is_defined(double x) {
  return std::isfinite(x);
}
inline bool is_defined(long double x) {
  return std::isfinite(x);
}
/// An undefined number for what follows from one. Types that hold several numbers, of which one may
/// be undefined alone, overload it: all of them are.
template <class T>
T undefined_of(T value) {
  return value;
}
/// Undefined operations of rationals throw.
inline bool is_defined(const Rational& /*x*/) {
  return true;
}

}  // namespace crest::kernel
