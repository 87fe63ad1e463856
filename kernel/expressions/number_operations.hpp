// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What an expression asks of a number type: functions, constants.
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "kernel/expressions/expression.hpp"

namespace crest::kernel {

/// sqrt, exp, log, sin and cos of a number type: std's or those found by the argument's namespace.
template <class T>
struct ElementaryFunctions {
  static T apply(Operation::Code code, const T& x) {
    using std::cos, std::exp, std::log, std::sin, std::sqrt;
    switch (code) {
      case Operation::Code::sqrt:
        return sqrt(x);
      case Operation::Code::exp:
        return exp(x);
      case Operation::Code::log:
        return log(x);
      case Operation::Code::sin:
        return sin(x);
      default:
        return cos(x);
    }
  }
};

/// Rationals have none: see Expression::rational().
template <>
struct ElementaryFunctions<Rational> {
  static Rational apply(Operation::Code, const Rational&) {
    throw std::domain_error("a function of the expression has no rational value");
  }
};

inline double as_double(const Constant& c) {
  return c.nearest;
}
/// Throws: std::domain_error for pi and e.
inline Rational as_rational(const Constant& c) {
  if (c.kind != Constant::Kind::number) throw std::domain_error("pi and e are not rational");
  return c.exact;
}

}  // namespace crest::kernel
