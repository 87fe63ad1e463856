// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Data section": expressions, by the grammar that stands in
// kernel/expressions/expression.hpp; and "Condition (A)": evaluation goes through every part, so a
// part that is not defined throws.
#include <string_view>
#include <vector>

#include "certify/second/series.hpp"

namespace crest::recheck {

struct Step {
  enum class Code {
    number,
    pi,
    e,
    variable,
    add,
    subtract,
    multiply,
    divide,
    negate,
    power,
    apply
  };
  Code code;
  int argument = 0;  ///< number, variable, exponent
  Function function{};
};

class Expression {
 public:
  /// Throws: Rejected for a text outside the grammar or the limits, of more than 8192 words.
  static Expression parse(std::string_view text, const std::vector<std::string>& variables);

  const std::vector<Step>& steps() const { return steps_; }
  const Rational& number(const Step& s) const {
    return numbers_[static_cast<std::size_t>(s.argument)];
  }

  /// The value, for T = Jet<...>, a model or an interval.
  /// Throws: Undefined if a part is not certainly defined (for jets that have a degree: analytic).
  template <class T>
  T evaluate(const std::vector<T>& variables) const {
    std::vector<T> stack;
    for (const Step& s : steps_) step(s, variables, stack);
    return stack.back();
  }

 private:
  friend class Parser;
  template <class T>
  void step(const Step& s, const std::vector<T>& variables, std::vector<T>& stack) const;
  Ball constant(const Step& s) const;

  std::vector<Step> steps_;
  std::vector<Rational> numbers_;
};

template <class T>
T integer_power(const T& x, int n) {
  if (n == 0) return T(1.0);
  if (n == 1) return x;
  if (n > 0) return applied({Function::Kind::power, static_cast<unsigned>(n)}, x);
  return applied({Function::Kind::inverse}, integer_power(x, -n));
}

template <class T>
void Expression::step(const Step& s, const std::vector<T>& variables, std::vector<T>& stack) const {
  using Code = Step::Code;
  const auto pop = [&] {
    T x = std::move(stack.back());
    stack.pop_back();
    return x;
  };
  const auto binary = [&](auto operation) {
    const T b = pop();
    stack.back() = operation(stack.back(), b);
  };
  switch (s.code) {
    case Code::number:
    case Code::pi:
    case Code::e:
      stack.push_back(T(constant(s)));
      break;
    case Code::variable:
      stack.push_back(variables[static_cast<std::size_t>(s.argument)]);
      break;
    case Code::add:
      binary([](const T& a, const T& b) { return a + b; });
      break;
    case Code::subtract:
      binary([](const T& a, const T& b) { return a - b; });
      break;
    case Code::multiply:
      binary([](const T& a, const T& b) { return a * b; });
      break;
    case Code::divide:
      binary([](const T& a, const T& b) { return a * applied({Function::Kind::inverse}, b); });
      break;
    case Code::negate:
      stack.back() = -stack.back();
      break;
    case Code::power:
      stack.back() = integer_power(stack.back(), s.argument);
      break;
    case Code::apply:
      stack.back() = applied(s.function, stack.back());
      break;
  }
}

}  // namespace crest::recheck
