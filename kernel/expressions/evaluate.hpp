// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An expression over any number type.
#include <cmath>
#include <memory>
#include <new>
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

/// x^n by repeated squaring. Requires: n >= 2.
template <class T>
T power(const T& x, std::uint32_t n) {
  if (n == 2) return x * x;
  if (n % 2 == 1) return power(x, n - 1) * x;
  const T half = power(x, n / 2);
  return half * half;
}
/// Requires: T(x) / T(x) is one.
template <class T>
T integer_power(const T& x, std::int32_t n, const T& one) {
  if (n < 0) return one / integer_power(x, -n, one);
  if (n < 2) return n == 0 ? one : x;
  return power(x, static_cast<std::uint32_t>(n));
}

/// The program with its constants as numbers of T, and places for its values: made once, called
/// often. Jets are large: a value is made in its place and read there, not copied on the way.
/// Not for two threads at a time.
template <class T>
class Evaluator {
 public:
  /// `convert` makes a T of a Constant (as_double, as_rational, an enclosure); `one` is T's one.
  template <class Convert>
  Evaluator(const Expression& expression, Convert&& convert, T one)
      : places_(expression.stack_depth() + 1), one_(std::move(one)) {
    for (const Constant& c : expression.constants()) constants_.push_back(convert(c));
    std::vector<Place*> unused;
    for (Place& place : places_) unused.push_back(&place);
    std::vector<Operand> stack;
    for (const Operation& operation : expression.program()) {
      const auto index = static_cast<std::size_t>(operation.argument);
      if (operation.code == Code::constant) {
        stack.push_back({&constants_[index], 0, nullptr});
      } else if (operation.code == Code::variable) {
        stack.push_back({nullptr, index, nullptr});
      } else {
        // A place other than its operands': these are read while it is filled.
        Place* const to = unused.back();
        unused.pop_back();
        const std::size_t count = is_binary(operation.code) ? 2 : 1;
        const Operand first = stack[stack.size() - count], last = stack.back();
        stack.resize(stack.size() - count);
        if (first.place != nullptr) unused.push_back(first.place);
        if (count == 2 && last.place != nullptr) unused.push_back(last.place);
        steps_.push_back({operation, first, last, to});
        stack.push_back({to->address(), 0, to});
      }
    }
    result_ = stack.back();
  }
  Evaluator(Evaluator&&) noexcept = default;
  Evaluator& operator=(Evaluator&&) noexcept = default;

  /// Requires: as many variables as the expression was parsed with.
  T operator()(std::span<const T> variables) {
    for (const Step& step : steps_) run(step, variables);
    return value(result_, variables);
  }

 private:
  using Code = Operation::Code;

  /// Room for a value.
  class Place {
   public:
    Place() noexcept {}
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() { clear(); }
    const T* address() const { return &value_; }
    /// What f() returns, made here.
    template <class Function>
    void make(Function&& f) {
      clear();
      ::new (static_cast<void*>(&value_)) T(f());
      full_ = true;
    }

   private:
    void clear() {
      if (full_) std::destroy_at(&value_);
      full_ = false;
    }
    union {
      T value_;
    };
    bool full_ = false;
  };
  struct Operand {
    const T* value;        ///< null: that of a variable
    std::size_t variable;  ///< its number
    Place* place;          ///< that holds the value, if one does
  };
  struct Step {
    Operation operation;
    Operand first, last;
    Place* to;
  };

  static bool is_binary(Code code) {
    return code == Code::add || code == Code::subtract || code == Code::multiply ||
           code == Code::divide;
  }
  static const T& value(const Operand& operand, std::span<const T> variables) {
    return operand.value != nullptr ? *operand.value : variables[operand.variable];
  }

  void run(const Step& step, std::span<const T> variables) {
    const T &a = value(step.first, variables), &b = value(step.last, variables);
    switch (step.operation.code) {
      case Code::add:
        return step.to->make([&] { return T(a + b); });
      case Code::subtract:
        return step.to->make([&] { return T(a - b); });
      case Code::multiply:
        return step.to->make([&] { return T(a * b); });
      case Code::divide:
        return step.to->make([&] { return T(a / b); });
      case Code::negate:
        return step.to->make([&] { return T(-a); });
      case Code::power:
        return step.to->make([&] { return integer_power(a, step.operation.argument, one_); });
      default:
        return step.to->make([&] { return ElementaryFunctions<T>::apply(step.operation.code, a); });
    }
  }

  std::vector<T> constants_;
  std::vector<Place> places_;
  std::vector<Step> steps_;
  Operand result_{};
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
