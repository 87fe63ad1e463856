// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An expression over any number type.
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

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

/// x^n by repeated squaring. Requires: T(x) / T(x) is one.
template <class T>
T integer_power(const T& x, std::int32_t n, const T& one) {
  if (n == 2) return x * x;  // nearly always: no copies
  T result = one, square = x;
  bool started = false;
  for (std::uint32_t bits = n < 0 ? 0u - static_cast<std::uint32_t>(n)
                                  : static_cast<std::uint32_t>(n);
       bits != 0; bits >>= 1) {
    if (bits & 1) {
      result = started ? result * square : square;
      started = true;
    }
    if (bits > 1) square = square * square;
  }
  return n < 0 ? one / result : result;
}

/// The program with its constants as numbers of T, and its stack: made once, called often.
/// Not for two threads at a time.
template <class T>
class Evaluator {
 public:
  /// `convert` makes a T of a Constant (as_double, as_rational, an enclosure); `one` is T's one.
  template <class Convert>
  Evaluator(const Expression& expression, Convert&& convert, T one)
      : program_(expression.program()), one_(std::move(one)) {
    for (const Constant& c : expression.constants()) constants_.push_back(convert(c));
    stack_.reserve(expression.stack_depth());
  }

  /// Requires: as many variables as the expression was parsed with.
  T operator()(std::span<const T> variables) {
    stack_.clear();
    for (const Operation& operation : program_) step(operation, variables);
    return stack_.back();
  }

 private:
  using Code = Operation::Code;

  void step(const Operation& operation, std::span<const T> variables) {
    switch (operation.code) {
      case Code::constant:
        return stack_.push_back(constants_[static_cast<std::size_t>(operation.argument)]);
      case Code::variable:
        return stack_.push_back(variables[static_cast<std::size_t>(operation.argument)]);
      case Code::add:
        return combine([](const T& a, const T& b) { return T(a + b); });
      case Code::subtract:
        return combine([](const T& a, const T& b) { return T(a - b); });
      case Code::multiply:
        return combine([](const T& a, const T& b) { return T(a * b); });
      case Code::divide:
        return combine([](const T& a, const T& b) { return T(a / b); });
      case Code::negate:
        stack_.back() = -stack_.back();
        return;
      case Code::power:
        stack_.back() = integer_power(stack_.back(), operation.argument, one_);
        return;
      default:
        stack_.back() = ElementaryFunctions<T>::apply(operation.code, stack_.back());
    }
  }

  template <class Combine>
  void combine(Combine&& combine) {
    const T b = std::move(stack_.back());
    stack_.pop_back();
    stack_.back() = combine(stack_.back(), b);
  }

  std::vector<Operation> program_;
  std::vector<T> constants_, stack_;
  T one_;
};

inline Evaluator<double> double_evaluator(const Expression& expression) {
  return {expression, as_double, 1.0};
}
/// Throws: std::domain_error unless expression.rational(); its calls throw std::overflow_error for
/// a division by zero.
inline Evaluator<Rational> rational_evaluator(const Expression& expression) {
  return {expression, as_rational, Rational(1)};
}

}  // namespace crest::kernel
