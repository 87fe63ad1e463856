// SPDX-License-Identifier: GPL-3.0-or-later
// Recursive descent over the grammar of expression.hpp.
#include "kernel/expressions/expression.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <utility>

namespace crest::kernel {
namespace {

using Code = Operation::Code;

constexpr int kDeepest = 200;
constexpr std::int64_t kLargestPower = 1000, kLargestDecimal = 400;
constexpr std::size_t kLongestNumber = 1000;

constexpr std::array<std::pair<std::string_view, Code>, 5> kFunctions = {{{"sqrt", Code::sqrt},
                                                                          {"exp", Code::exp},
                                                                          {"log", Code::log},
                                                                          {"sin", Code::sin},
                                                                          {"cos", Code::cos}}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

boost::multiprecision::mpz_int ten_to(std::int64_t n) {
  boost::multiprecision::mpz_int result = 1;
  for (std::int64_t i = 0; i < n; ++i) result *= 10;
  return result;
}

/// At most kLargestPower + 1, which the caller refuses.
std::int64_t capped_power(std::int64_t base, std::int64_t exponent) {
  std::int64_t result = 1;
  for (std::int64_t i = 0; i < exponent; ++i) {
    result = std::min(result * base, kLargestPower + 1);
    if (result == 0 || result == 1 || result > kLargestPower) break;
  }
  return result;
}

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
    if (peek() != '\0' || at_ < text_.size()) expected("an operator or the end");
  }

 private:
  /// Counts how deep the recursion is, and stops it.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.level_ > kDeepest) parser_.fail(parser_.at_, "is nested too deeply");
    }
    ~Level() { --parser_.level_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    throw ExpressionError(at + 1, what);
  }

  [[noreturn]] void expected(const std::string& what) {
    peek();
    if (at_ >= text_.size()) fail(at_, what + " is expected, not the end");
    const char c = text_[at_];
    std::string found = "a special character";
    if (c > ' ' && c < 0x7f) found = {'\'', c, '\''};
    fail(at_, what + " is expected, not " + found);
  }

  /// The next character that is not blank; 0 at the end.
  char peek() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c || at_ >= text_.size()) return false;
    ++at_;
    return true;
  }

  /// The step that ends the part of the text from `begin` to here.
  void emit(Code code, std::size_t begin, std::int64_t argument = 0) {
    program_.push_back({code, static_cast<std::int32_t>(argument)});
    std::size_t end = at_;
    while (is_blank(text_[end - 1])) --end;  // looked past for the next operator
    places_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
  }
  /// Of what comes next.
  std::size_t begin() {
    peek();
    return at_;
  }

  void sum() {
    const std::size_t first = begin();
    product();
    for (;;) {
      if (accept('+')) {
        product();
        emit(Code::add, first);
      } else if (accept('-')) {
        product();
        emit(Code::subtract, first);
      } else {
        return;
      }
    }
  }

  void product() {
    const std::size_t first = begin();
    sign();
    for (;;) {
      if (accept('*')) {
        sign();
        emit(Code::multiply, first);
      } else if (accept('/')) {
        sign();
        emit(Code::divide, first);
      } else {
        return;
      }
    }
  }

  void sign() {
    const Level level(*this);
    const std::size_t first = begin();
    if (accept('+')) return sign();
    if (accept('-')) {
      sign();
      return emit(Code::negate, first);
    }
    atom();
    if (accept('^')) {
      const std::size_t begin = at_;
      const std::int64_t n = exponent();
      if (n > kLargestPower || n < -kLargestPower) fail(begin, "the exponent is beyond 1000");
      emit(Code::power, first, n);
    }
  }

  /// Between -1001 and 1001, the ends meaning "beyond".
  std::int64_t exponent() {
    const Level level(*this);
    if (accept('+')) return exponent();
    if (accept('-')) return -exponent();
    std::int64_t base = 0;
    if (accept('(')) {
      base = exponent();
      if (!accept(')')) expected("')'");
    } else {
      if (!is_digit(peek())) expected("an integer exponent");
      for (; at_ < text_.size() && is_digit(text_[at_]); ++at_)
        base = std::min<std::int64_t>(10 * base + (text_[at_] - '0'), kLargestPower + 1);
      if (at_ < text_.size() && (text_[at_] == '.' || is_letter(text_[at_])))
        expected("an integer exponent");
    }
    if (!accept('^')) return base;
    const std::size_t begin = at_;
    const std::int64_t n = exponent();
    if (n < 0) fail(begin, "a non-negative exponent of an exponent is expected");
    return base < 0 && n % 2 != 0 ? -capped_power(-base, n) : capped_power(std::abs(base), n);
  }

  void atom() {
    const char c = peek();
    if (accept('(')) {
      sum();
      if (!accept(')')) expected("an operator or ')'");
    } else if (is_digit(c) || c == '.') {
      number();
    } else if (is_letter(c)) {
      name();
    } else {
      expected("a number, a name or '('");
    }
  }

  std::string_view digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void number() {
    const std::size_t begin = at_;
    std::string mantissa(digits());
    std::int64_t decimals = 0;
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      const std::string_view fraction = digits();
      mantissa += fraction;
      decimals = static_cast<std::int64_t>(fraction.size());
    }
    if (mantissa.empty()) expected("a digit");
    std::int64_t shift = 0;
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) shift = scale();
    if (at_ - begin > kLongestNumber || std::abs(shift) > kLargestDecimal)
      fail(begin, "the number is too long or beyond 1e400");
    // A leading zero would mean octal.
    mantissa.erase(0, std::min(mantissa.find_first_not_of('0'), mantissa.size() - 1));
    shift -= decimals;
    Constant c{Constant::Kind::number, Rational(boost::multiprecision::mpz_int(mantissa)), 0};
    const Rational power(ten_to(std::abs(shift)));
    c.exact = shift < 0 ? Rational(c.exact / power) : Rational(c.exact * power);
    c.nearest = c.exact.convert_to<double>();
    // The conversion above may truncate.
    std::from_chars(text_.data() + begin, text_.data() + at_, c.nearest);
    push(std::move(c), begin);
  }

  /// The power of ten after 'e'; beyond the limit once it is not certain to fit.
  std::int64_t scale() {
    ++at_;
    const bool negative = at_ < text_.size() && text_[at_] == '-';
    if (negative || (at_ < text_.size() && text_[at_] == '+')) ++at_;
    std::int64_t value = 0;
    const std::string_view text = digits();
    if (text.empty()) expected("a digit of the power of ten");
    for (const char c : text) value = std::min(10 * value + (c - '0'), kLargestDecimal + 1);
    return negative ? -value : value;
  }

  void push(Constant c, std::size_t begin) {
    constants_.push_back(std::move(c));
    emit(Code::constant, begin, static_cast<std::int64_t>(constants_.size() - 1));
  }

  void name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    const auto variable = std::find(variables_.begin(), variables_.end(), word);
    if (variable != variables_.end())
      return emit(Code::variable, begin, variable - variables_.begin());
    if (word == "pi") return push({Constant::Kind::pi, 0, std::numbers::pi}, begin);
    if (word == "e") return push({Constant::Kind::e, 0, std::numbers::e}, begin);
    for (const auto& [function, code] : kFunctions) {
      if (word != function) continue;
      if (!accept('(')) expected(std::string("'(' after ").append(word));
      sum();
      if (!accept(')')) expected("an operator or ')'");
      return emit(code, begin);
    }
    std::string known;
    for (const std::string& v : variables_) known.append(v).append(", ");
    for (const auto& [function, code] : kFunctions) known.append(function).append(", ");
    std::string what(1, '\'');
    what.append(word.substr(0, 40)).append("' is unknown; there are ").append(known);
    fail(begin, what.append("pi, e"));
  }

  std::string_view text_;
  const std::vector<std::string>& variables_;
  std::vector<Operation>& program_;
  std::vector<Constant>& constants_;
  std::vector<Expression::Place>& places_;
  std::size_t at_ = 0;
  int level_ = 0;
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
