// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Expressions over any number type.
#include <array>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "kernel/arithmetic/defined.hpp"
#include "kernel/expressions/number_operations.hpp"
#include "kernel/expressions/schedule.hpp"

namespace crest::kernel {

/// A schedule with its constants as numbers of T, and places for its values: made once, called
/// often. Jets are large: a value is made in its place and read there, not copied on the way.
/// Not for two threads at a time.
template <class T>
class Evaluator {
 public:
  /// `convert` makes a T of a Constant (as_double, as_rational, an enclosure); `one` is T's one.
  template <class Convert>
  Evaluator(std::span<const Expression> expressions, Convert&& convert, T one) {
    const Schedule plan = schedule(expressions);
    places_ = std::vector<Place>(plan.places);
    for (const Constant& c : plan.constants) constants_.push_back(convert(c));
    constants_.push_back(std::move(one));
    const auto operand = [&](const Schedule::Operand& x) -> Operand {
      using Kind = Schedule::Operand::Kind;
      if (x.kind == Kind::variable) return {nullptr, x.index};
      if (x.kind == Kind::step) return {places_[plan.steps[x.index].place].address(), 0};
      return {x.kind == Kind::one ? &constants_.back() : &constants_[x.index], 0};
    };
    for (const Schedule::Step& s : plan.steps)
      steps_.push_back({s.code, operand(s.first), operand(s.last), &places_[s.place]});
    for (const Schedule::Operand& x : plan.results) results_.push_back(operand(x));
  }
  template <class Convert>
  Evaluator(const Expression& expression, Convert&& convert, T one)
      : Evaluator(std::span(&expression, 1), convert, std::move(one)) {}
  Evaluator(Evaluator&&) noexcept = default;
  Evaluator& operator=(Evaluator&&) noexcept = default;

  /// Requires: as many variables as the expressions were parsed with.
  T operator()(std::span<const T> variables) { return all<1>(variables)[0]; }
  /// The first n expressions' values. Requires: there are so many.
  template <std::size_t n>
  std::array<T, n> all(std::span<const T> variables) {
    for (const Step& step : steps_) run(step, variables);
    return [&]<std::size_t... k>(std::index_sequence<k...>) {
      return std::array<T, n>{value(results_[k], variables)...};
    }
    (std::make_index_sequence<n>());
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
  };
  struct Step {
    Code code;
    Operand first, last;
    Place* to;
  };

  static const T& value(const Operand& operand, std::span<const T> variables) {
    return operand.value != nullptr ? *operand.value : variables[operand.variable];
  }

  void run(const Step& step, std::span<const T> variables) {
    const T &a = value(step.first, variables), &b = value(step.last, variables);
    switch (step.code) {
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
      case Code::power:  // 0: what is undefined stays so
        return step.to->make([&] { return is_defined(a) ? constants_.back() : undefined_of(a); });
      default:
        return step.to->make([&] { return ElementaryFunctions<T>::apply(step.code, a); });
    }
  }

  std::vector<T> constants_;
  std::vector<Place> places_;
  std::vector<Step> steps_;
  std::vector<Operand> results_;
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
