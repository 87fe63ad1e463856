// SPDX-License-Identifier: GPL-3.0-or-later
// Recursive descent over the grammar of expression.hpp.
#include "kernel/expressions/expression.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "kernel/expressions/expression_text.hpp"

namespace crest::kernel {
namespace {

using Code = Operation::Code;

constexpr std::array<std::pair<std::string_view, Code>, 5> kFunctions = {{{"sqrt", Code::sqrt},
                                                                          {"exp", Code::exp},
                                                                          {"log", Code::log},
                                                                          {"sin", Code::sin},
                                                                          {"cos", Code::cos}}};

class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& variables,
         std::vector<Operation>& program, std::vector<Constant>& constants,
         std::vector<Expression::Place>& places)
      : text_(text),
        variables_(variables),
        program_(program),
        constants_(constants),
        places_(places) {}

  void run() {
    sum();
    if (text_.peek() != '\0' || !text_.at_end()) text_.expected("an operator or the end");
  }

 private:
  /// The step that ends the part of the text from `begin` to here.
  void emit(Code code, std::size_t begin, std::int64_t argument = 0) {
    program_.push_back({code, static_cast<std::int32_t>(argument)});
    places_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(text_.end())});
  }

  void sum() {
    const std::size_t first = text_.begin();
    product();
    for (;;) {
      if (text_.accept('+')) {
        product();
        emit(Code::add, first);
      } else if (text_.accept('-')) {
        product();
        emit(Code::subtract, first);
      } else {
        return;
      }
    }
  }

  void product() {
    const std::size_t first = text_.begin();
    sign();
    for (;;) {
      if (text_.accept('*')) {
        sign();
        emit(Code::multiply, first);
      } else if (text_.accept('/')) {
        sign();
        emit(Code::divide, first);
      } else {
        return;
      }
    }
  }

  void sign() {
    const ExpressionText::Level level(text_);
    const std::size_t first = text_.begin();
    if (text_.accept('+')) return sign();
    if (text_.accept('-')) {
      sign();
      return emit(Code::negate, first);
    }
    atom();
    if (!text_.accept('^')) return;
    const std::int64_t n = text_.exponent();
    emit(Code::power, first, n);
  }

  void atom() {
    const std::size_t first = text_.begin();
    if (text_.accept('('))
      bracket();
    else if (text_.number_is_next())
      push(text_.number(), first);
    else if (text_.name_is_next())
      name(first);
    else
      text_.expected("a number, a name or '('");
  }

  void bracket() {
    sum();
    if (!text_.accept(')')) text_.expected("an operator or ')'");
  }

  void push(Constant c, std::size_t begin) {
    constants_.push_back(std::move(c));
    emit(Code::constant, begin, static_cast<std::int64_t>(constants_.size() - 1));
  }

  void name(std::size_t begin) {
    const std::string_view word = text_.name();
    const auto variable = std::find(variables_.begin(), variables_.end(), word);
    if (variable != variables_.end())
      return emit(Code::variable, begin, variable - variables_.begin());
    if (word == "pi") return push({Constant::Kind::pi, 0, std::numbers::pi}, begin);
    if (word == "e") return push({Constant::Kind::e, 0, std::numbers::e}, begin);
    for (const auto& [function, code] : kFunctions) {
      if (word != function) continue;
      if (!text_.accept('(')) text_.expected(std::string("'(' after ").append(word));
      bracket();
      return emit(code, begin);
    }
    std::string known;
    for (const std::string& v : variables_) known.append(v).append(", ");
    for (const auto& [function, code] : kFunctions) known.append(function).append(", ");
    std::string what(1, '\'');
    what.append(word.substr(0, 40)).append("' is unknown; there are ").append(known);
    text_.fail(begin, what.append("pi, e"));
  }

  ExpressionText text_;
  const std::vector<std::string>& variables_;
  std::vector<Operation>& program_;
  std::vector<Constant>& constants_;
  std::vector<Expression::Place>& places_;
};

}  // namespace

ExpressionError::ExpressionError(std::size_t column, const std::string& what)
    : std::runtime_error("column " + std::to_string(column) + ": " + what), column_(column) {}

Expression Expression::parse(std::string_view text, const std::vector<std::string>& variables) {
  Expression result;
  result.text_ = text;
  result.variable_count_ = variables.size();
  Parser(text, variables, result.program_, result.constants_, result.places_).run();
  return result;
}

bool Expression::rational() const {
  return std::all_of(program_.begin(), program_.end(),
                     [](const Operation& o) { return o.code <= Code::power; }) &&
         std::all_of(constants_.begin(), constants_.end(),
                     [](const Constant& c) { return c.kind == Constant::Kind::number; });
}

bool Expression::affine() const {
  std::vector<int> degrees;  // 2: more than one, or no polynomial
  for (const Operation& o : program_) {
    if (o.code == Code::constant || o.code == Code::variable) {
      degrees.push_back(o.code == Code::variable ? 1 : 0);
    } else if (o.code >= Code::add && o.code <= Code::divide) {
      const int b = degrees.back();
      degrees.pop_back();
      int& a = degrees.back();
      if (o.code == Code::multiply)
        a = std::min(a + b, 2);
      else if (o.code == Code::divide)
        a = b > 0 ? 2 : a;
      else
        a = std::max(a, b);
    } else if (o.code != Code::negate) {
      int& a = degrees.back();
      const bool same = o.code == Code::power && o.argument == 1;
      if (a > 0 && !same) a = 2;
    }
  }
  return degrees.back() < 2;
}

}  // namespace crest::kernel
