// SPDX-License-Identifier: GPL-3.0-or-later
// What expressions are worth, over doubles and rationals.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernel/expressions/evaluate.hpp"
#include "tests/kernel/xyz.hpp"
#include "tests/support/degenerate_families.hpp"

namespace {

using namespace crest::kernel;
using crest::tests::Draw;
using crest::tests::kXyz;

Rational exact(const std::string& text, const std::vector<Rational>& at = {2, 3, 5}) {
  return rational_evaluator(Expression::parse(text, kXyz))(at);
}

double rounded(const std::string& text, const std::vector<double>& at = {2, 3, 5}) {
  return double_evaluator(Expression::parse(text, kXyz))(at);
}

/// A random expression as text and, computed beside it without the parser, its value.
struct Grown {
  std::string text;
  Rational value;
};
Grown grow(Draw& d, int depth, const std::vector<Rational>& at) {
  if (depth == 0) {
    const int which = d.integer(0, 4);
    if (which < 3)
      return {kXyz[static_cast<std::size_t>(which)], at[static_cast<std::size_t>(which)]};
    const int n = d.integer(0, 99);
    if (which == 3) return {std::to_string(n), n};
    return {std::to_string(n) + ".25e-1", Rational(100 * n + 25, 1000)};
  }
  const Grown a = grow(d, depth - 1, at), b = grow(d, depth - 1, at);
  switch (d.integer(0, 5)) {
    case 0:
      return {"(" + a.text + " + " + b.text + ")", a.value + b.value};
    case 1:
      return {"(" + a.text + " - " + b.text + ")", a.value - b.value};
    case 2:
      return {"(" + a.text + ")*(" + b.text + ")", a.value * b.value};
    case 3:
      if (b.value == 0) return a;
      return {"(" + a.text + ")/(" + b.text + ")", a.value / b.value};
    case 4:
      return {"(-(" + a.text + "))", -a.value};
    default:
      return {"(" + a.text + ")^3", a.value * a.value * a.value};
  }
}

}  // namespace

TEST_CASE("precedence and associativity") {
  CHECK(exact("1 + 2*3") == 7);
  CHECK(exact("(1 + 2)*3") == 9);
  CHECK(exact("10 - 4 - 3") == 3);
  CHECK(exact("24/4/3") == 2);
  CHECK(exact("24/4*3") == 18);
  CHECK(exact("-x^2") == -4);
  CHECK(exact("(-x)^2") == 4);
  CHECK(exact("2*-x") == -4);
  CHECK(exact("--x") == 2);
  CHECK(exact("- + -x") == 2);
  CHECK(exact("x^2^3") == 256);  // x^(2^3)
  CHECK(exact("(x^2)^3") == 64);
  CHECK(exact("x^-2") == Rational(1, 4));
  CHECK(exact("x^(-2)") == Rational(1, 4));
  CHECK(exact("x^-2^2") == Rational(1, 16));
  CHECK(exact("x^(2)^2") == 16);
  CHECK(exact("x^(-2)^3") == Rational(1, 256));
  CHECK(exact("x^0") == 1);
  CHECK(exact("0^0") == 1);
  CHECK(exact("x^1^2000") == 2);
  CHECK(exact("2*x^2*y") == 24);
  CHECK(exact("1 - x^2") == -3);
  CHECK(exact("x*x - y*z") == -11);
  CHECK(exact(" \tx\n") == 2);
}

TEST_CASE("numbers are exact") {
  CHECK(exact("0.1") == Rational(1, 10));
  CHECK(exact("1e-3") == Rational(1, 1000));
  CHECK(exact("2.5E+2") == 250);
  CHECK(exact(".5") == Rational(1, 2));
  CHECK(exact("5.") == 5);
  CHECK(exact("007") == 7);  // not octal
  CHECK(exact("010.010") == Rational(1001, 100));
  CHECK(exact("0.1 + 0.2 - 0.3") == 0);
  CHECK(rounded("0.1 + 0.2 - 0.3") != 0);
  CHECK(rounded("1e400") == std::numeric_limits<double>::infinity());
  CHECK(rounded("1e-400") == 0);
  CHECK(rounded("9007199254740993") == 9007199254740992.0);
  CHECK(rounded("0.30000000000000004") == 0.30000000000000004);
}

TEST_CASE("functions and constants") {
  CHECK(rounded("pi") == std::acos(-1.0));
  CHECK(rounded("e") == std::exp(1.0));
  CHECK(rounded("sqrt(x)") == std::sqrt(2.0));
  CHECK(rounded("exp(x)*log(y)") == std::exp(2.0) * std::log(3.0));
  CHECK(rounded("sin(x) - cos(y)") == std::sin(2.0) - std::cos(3.0));
  CHECK(rounded("sin(cos(x*y) + 1)^2") == std::pow(std::sin(std::cos(6.0) + 1), 2));
  CHECK(std::isnan(rounded("log(-1)")));
  CHECK(std::isinf(rounded("1/(x - 2)")));
  CHECK_THROWS_AS(exact("pi"), std::domain_error);
  CHECK_THROWS_AS(exact("sqrt(4)"), std::domain_error);
  CHECK_THROWS_AS(exact("1/(x - 2)"), std::overflow_error);
  const Expression hidden = Expression::parse("e + pi", {"e", "pi"});
  CHECK(rational_evaluator(hidden)(std::vector<Rational>{1, 2}) == 3);
}

TEST_CASE("random expressions have the values that rationals give them") {
  Draw d(42);
  for (std::uint64_t i = 0; i < crest::tests::scaled(2000); ++i) {
    const std::vector<Rational> at = {Rational(d.integer(-9, 9), 4), Rational(d.integer(-9, 9), 7),
                                      d.integer(-9, 9)};
    const Grown grown = grow(d, d.integer(1, 4), at);
    INFO("trial " << i << ": " << grown.text);
    const Expression e = Expression::parse(grown.text, kXyz);
    CHECK(e.rational());
    CHECK(rational_evaluator(e)(at) == grown.value);
  }
}
