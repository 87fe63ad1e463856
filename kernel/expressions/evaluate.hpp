// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An expression over any number type.
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "kernel/expressions/number_operations.hpp"

namespace crest::kernel {

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
