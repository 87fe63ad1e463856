// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/expressions/expression_text.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace crest::kernel {
namespace {

constexpr std::int64_t kLargestPower = 1000, kLargestDecimal = 400;
constexpr std::size_t kLongestNumber = 1000;

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

}  // namespace

char ExpressionText::peek() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool ExpressionText::accept(char c) {
  if (peek() != c || at_end()) return false;
  ++at_;
  return true;
}

std::size_t ExpressionText::end() const {
  std::size_t end = at_;
  while (is_blank(text_[end - 1])) --end;
  return end;
}

void ExpressionText::expected(const std::string& what) {
  peek();
  if (at_ >= text_.size()) fail(at_, what + " is expected, not the end");
  const char c = text_[at_];
  std::string found = "a special character";
  if (c > ' ' && c < 0x7f) found = {'\'', c, '\''};
  fail(at_, what + " is expected, not " + found);
}

bool ExpressionText::number_is_next() {
  const char c = peek();
  return is_digit(c) || c == '.';
}

bool ExpressionText::name_is_next() {
  return is_letter(peek());
}

std::string_view ExpressionText::name() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::int64_t ExpressionText::exponent() {
  const std::size_t begin = at_;
  const std::int64_t n = nested_exponent();
  if (n > kLargestPower || n < -kLargestPower) fail(begin, "the exponent is beyond 1000");
  return n;
}

/// Between -1001 and 1001, the ends meaning "beyond".
std::int64_t ExpressionText::nested_exponent() {
  const Level level(*this);
  if (accept('+')) return nested_exponent();
  if (accept('-')) return -nested_exponent();
  std::int64_t base = 0;
  if (accept('(')) {
    base = nested_exponent();
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
  const std::int64_t n = nested_exponent();
  if (n < 0) fail(begin, "a non-negative exponent of an exponent is expected");
  return base < 0 && n % 2 != 0 ? -capped_power(-base, n) : capped_power(std::abs(base), n);
}

std::string_view ExpressionText::digits() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

Constant ExpressionText::number() {
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
#ifdef __cpp_lib_to_chars
  std::from_chars(text_.data() + begin, text_.data() + at_, c.nearest);
#else
  c.nearest = std::strtod(std::string(text_.substr(begin, at_ - begin)).c_str(), nullptr);
#endif
  return c;
}

/// The power of ten after 'e'; beyond the limit once it is not certain to fit.
std::int64_t ExpressionText::scale() {
  ++at_;
  const bool negative = at_ < text_.size() && text_[at_] == '-';
  if (negative || (at_ < text_.size() && text_[at_] == '+')) ++at_;
  std::int64_t value = 0;
  const std::string_view text = digits();
  if (text.empty()) expected("a digit of the power of ten");
  for (const char c : text) value = std::min(10 * value + (c - '0'), kLargestDecimal + 1);
  return negative ? -value : value;
}

}  // namespace crest::kernel
