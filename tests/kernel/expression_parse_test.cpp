// SPDX-License-Identifier: GPL-3.0-or-later
// Which texts are expressions, and where the others go wrong.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "kernel/expressions/evaluate.hpp"
#include "tests/kernel/xyz.hpp"
#include "tests/support/degenerate_families.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

ExpressionError parse_error(const std::string& text) {
  try {
    Expression::parse(text, kXyz);
  } catch (const ExpressionError& error) {
    return error;
  }
  return {0, "no error"};
}

std::string before_x(std::size_t count, char c) {
  std::string text(count + 1, c);
  text.back() = 'x';
  return text;
}

}  // namespace

TEST_CASE("errors name the column and what was expected, in one line") {
  struct Case {
    std::string text;
    std::size_t column;
    std::string expected;
  };
  const Case cases[] = {
      {"", 1, "a number, a name or '(' is expected, not the end"},
      {"   ", 4, "not the end"},
      {"x +", 4, "a number, a name or '('"},
      {"x * / y", 5, "a number, a name or '(' is expected, not '/'"},
      {"2 x", 3, "an operator or the end is expected, not 'x'"},
      {"(x + y", 7, "an operator or ')' is expected, not the end"},
      {"x + y)", 6, "an operator or the end is expected, not ')'"},
      {"sin x", 5, "'(' after sin"},
      {"sqrt(x", 7, "an operator or ')'"},
      {"x ^ y", 5, "an integer exponent is expected, not 'y'"},
      {"x^2.5", 4, "an integer exponent"},
      {"x^2e3", 4, "an integer exponent"},
      {"x^1001", 3, "beyond 1000"},
      {"x^9^9^9^9", 3, "beyond 1000"},
      {"x^2^-1", 5, "non-negative"},
      {"w + 1", 1, "'w' is unknown; there are x, y, z, sqrt, exp, log, sin, cos, pi, e"},
      {"1e", 3, "a digit of the power of ten"},
      {"1e401", 1, "beyond 1e400"},
      {"1e99999999999999999999", 1, "beyond 1e400"},
      {".", 2, "a digit"},
      {"x\x01", 2, "not a special character"},
      {"x $ y", 3, "not '$'"},
      {std::string("x\0y", 3), 2, "an operator or the end"},
      {before_x(300, '('), 201, "nested too deeply"},
      {before_x(300, '-'), 201, "nested too deeply"},
      {std::string(1001, '1'), 1, "too long"},
  };
  for (const Case& c : cases) {
    const ExpressionError error = parse_error(c.text);
    INFO(c.text << " -> " << error.what());
    CHECK(error.column() == c.column);
    const std::string line = error.what();
    CHECK(line.starts_with("column " + std::to_string(c.column) + ": "));
    CHECK(line.find(c.expected) != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
}

TEST_CASE("the program is compact") {
  const Expression e = Expression::parse("x*x - y*z", kXyz);
  CHECK(e.program().size() == 7);
  CHECK(e.constants().empty());
  CHECK(e.rational());
  CHECK_FALSE(Expression::parse("sin(x)", kXyz).rational());
  CHECK_FALSE(Expression::parse("2*pi", kXyz).rational());
  const Expression half = Expression::parse("0.1", kXyz);
  CHECK(half.constants()[0].exact == Rational(1, 10));
  CHECK(half.constants()[0].nearest == 0.1);
}

TEST_CASE("random strings give an expression or an error, never more") {
  const std::string alphabet = "xyze.0123456789+-*/^() \tsqrtlogincp\n#";
  crest::tests::Draw d(41);
  const auto trials = crest::tests::scaled(200000);
  std::size_t parsed = 0;
  for (std::uint64_t i = 0; i < trials; ++i) {
    std::string text;
    for (int n = d.integer(0, 14); n > 0; --n) {
      text += d.integer(0, 40) == 0 ? static_cast<char>(d.integer(-128, 127))
                                    : alphabet[static_cast<std::size_t>(
                                          d.integer(0, static_cast<int>(alphabet.size()) - 1))];
    }
    INFO("trial " << i << ": " << text);
    try {
      const Expression e = Expression::parse(text, kXyz);
      const double at[] = {0.5, -2, 3};
      double_evaluator(e)(at);
      ++parsed;
    } catch (const ExpressionError& error) {
      if (error.column() < 1 || error.column() > text.size() + 1) FAIL(error.what());
      if (std::string(error.what()).find('\n') != std::string::npos) FAIL(error.what());
    }
  }
  CHECK(parsed > trials / 200);
}

TEST_CASE("expressions: which are affine as they are written") {
  const auto affine = [](const char* text) { return Expression::parse(text, {"x", "y"}).affine(); };
  for (const char* text : {"0", "x", "-x", "x + 0.1*y - 3", "(x - y)/7", "x*2", "2*x*3", "x^1",
                           "3^2*x", "sin(1)*x + pi", "-(x/(2 - e))", "x^(1)^1", "2^2^3", "x - x"}) {
    CAPTURE(text);
    CHECK(affine(text));
  }
  for (const char* text : {"x*y", "x^2", "1/x", "x/y", "sin(x)", "sqrt(x)", "x*(y + 1)", "x^0",
                           "x^-1", "x + y*y", "x*y - x*y + x", "2 + exp(y)", "(x*y)*0"}) {
    CAPTURE(text);
    CHECK_FALSE(affine(text));
  }
}

TEST_CASE("Every step of a program knows its part of the text") {
  const std::string text = " -x ^2+ log( y - 1)/ (2*3) - x*y/pi";
  const auto e = Expression::parse(text, {"x", "y"});
  std::vector<std::string> parts;
  REQUIRE(e.places().size() == e.program().size());
  for (const auto& [begin, end] : e.places()) parts.push_back(text.substr(begin, end - begin));
  const std::vector<std::string> expected = {"x",
                                             "x ^2",
                                             "-x ^2",
                                             "y",
                                             "1",
                                             "y - 1",
                                             "log( y - 1)",
                                             "2",
                                             "3",
                                             "2*3",
                                             "log( y - 1)/ (2*3)",
                                             " -x ^2+ log( y - 1)/ (2*3)",
                                             "x",
                                             "y",
                                             "x*y",
                                             "pi",
                                             "x*y/pi",
                                             text};
  std::vector<std::string> trimmed;
  for (const auto& p : expected) trimmed.push_back(p.substr(p.find_first_not_of(' ')));
  CHECK(parts == trimmed);
}
