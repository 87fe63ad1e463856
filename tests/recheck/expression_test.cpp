// SPDX-License-Identifier: GPL-3.0-or-later
// The second checker's parser: the grammar, its limits, periods, and parts that are not defined.
#include "certify/second/expression.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "certify/second/jet.hpp"
#include "certify/second/model.hpp"
#include "certify/second/periods.hpp"

namespace {

using namespace crest::recheck;

const std::vector<std::string> kNames = {"x", "y", "z"};

double value(const std::string& text, double x = 0, double y = 0, double z = 0) {
  const Ball b = Expression::parse(text, kNames).evaluate<Ball>({x, y, z});
  return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR);
}

bool undefined(const std::string& text, const Interval& x) {
  try {
    Expression::parse(text, kNames).evaluate<Interval>({x, x, x});
    return false;
  } catch (const Undefined&) {
    return true;
  }
}

}  // namespace

TEST_CASE("recheck: expressions mean what the grammar says") {
  CHECK(value("-x^2", 3) == -9);
  CHECK(value("2^3^2") == 512);
  CHECK(value("x^-2", 2) == 0.25);
  CHECK(value("x^-1^2", 2) == 0.5);
  CHECK(value("x^(-2)", 2) == 0.25);
  CHECK(value("1-2-3") == -4);
  CHECK(value("8/2/2") == 2);
  CHECK(value("2*-3") == -6);
  CHECK(value("- - 3") == 3);
  CHECK(value("+-+3") == -3);
  CHECK(value(".5+5.+1e1") == 15.5);
  CHECK(value("2E-1") == 0.2);
  CHECK(value(" ( x + y ) * z ", 1, 2, 3) == 9);
  CHECK(value("2*e") == Approx(2 * std::exp(1.0)).epsilon(1e-15));
  CHECK(value("sin(pi/6)") == Approx(0.5).epsilon(1e-15));
  CHECK(value("log(exp(2))+sqrt(4)") == Approx(4).epsilon(1e-15));
  CHECK(value("x^0", 0) == 1);
  CHECK(value("0.1") == 0.1);
}

TEST_CASE("recheck: texts outside the grammar or its limits are refused") {
  const std::string deep(201, '('), signs(201, '-');
  std::string many = "x";
  for (int k = 0; k < 4096; ++k) many += "*x";  // 8193 words
  for (const std::string& text : {std::string(""),
                                  std::string("x+"),
                                  std::string("2x"),
                                  std::string("x y"),
                                  std::string("x^0.5"),
                                  std::string("x^y"),
                                  std::string("x^1001"),
                                  std::string("x^10^4"),
                                  std::string("x^2^-1"),
                                  std::string("1e401"),
                                  std::string("1e-401"),
                                  std::string("1e"),
                                  std::string("1.") + std::string(1000, '1'),
                                  std::string("w"),
                                  std::string("sin x"),
                                  std::string("tan(x)"),
                                  std::string("(x"),
                                  std::string("x)"),
                                  std::string("x^"),
                                  std::string("."),
                                  std::string("x,y"),
                                  deep + "x" + std::string(201, ')'),
                                  signs + "x",
                                  many}) {
    INFO(text.substr(0, 40));
    CHECK_THROWS_AS(Expression::parse(text, kNames), Rejected);
  }
  CHECK_NOTHROW(Expression::parse(many.substr(2), kNames));
  CHECK_NOTHROW(Expression::parse("x^-1000+1e400+1e-400", kNames));
}

TEST_CASE("recheck: no operation absorbs what is not defined") {
  const Interval around(-1, 1), positive(1, 2);
  for (const char* part : {"log(x)", "1/x", "sqrt(x-1/2)", "x^-1", "log(0-1)", "sqrt(-1)", "1/0",
                           "log(x*x)", "1/(x-x)", "exp(1/x)"})
    for (const std::string context :
         {"P", "0*(P)", "(P)-(P)", "sin(P)", "(P)^0", "x*0*(P)", "1/(2+sin(P))"}) {
      std::string text = context;
      for (auto at = text.find('P'); at != std::string::npos; at = text.find('P', at))
        text.replace(at, 1, part);
      INFO(text);
      CHECK(undefined(text, around));
      const Scope scope(2);
      Model u = Model::linear(Ball(-1.0), Ball(2.0), Ball(1.5));
      CHECK_THROWS_AS(Expression::parse(text, kNames).evaluate<Model>({u, u, u}), Undefined);
      const Jet<Model, 1> jet(u, {Model(1.0)});
      CHECK_THROWS_AS((Expression::parse(text, kNames).evaluate<Jet<Model, 1>>({jet, jet, jet})),
                      Undefined);
    }
  CHECK_FALSE(undefined("log(x)+1/x+sqrt(x-1/2)", positive));
  CHECK_FALSE(undefined("sqrt(x^2)", around));
  const Scope scope(1);
  const Jet<Model, 1> zero(Model(0.0), {Model(1.0)});
  CHECK_THROWS_AS(
      (Expression::parse("sqrt(x)", kNames).evaluate<Jet<Model, 1>>({zero, zero, zero})),
      Undefined);
}

TEST_CASE("recheck: periods are proven by the rules alone") {
  const std::vector<std::string> uv = {"u", "v"};
  const auto invariant = [&](const std::string& text, slong n, ulong d) {
    return is_invariant(Expression::parse(text, uv), 0, Rational(n, d));
  };
  CHECK(invariant("sin(u)+v", 1, 1));
  CHECK(invariant("cos(2*u+v)", 1, 1));
  CHECK(invariant("cos(2*u)", 1, 2));
  CHECK(invariant("exp(sin(u))/(2+cos(u)^3)", 1, 1));
  CHECK(invariant("u-u", 1, 1));
  CHECK(invariant("sin(u/3)", 3, 1));
  CHECK_FALSE(invariant("sin(u/2)", 1, 1));
  CHECK_FALSE(invariant("u", 1, 1));
  CHECK_FALSE(invariant("sin(u^1)", 1, 1));
  CHECK_FALSE(invariant("sin(pi*u)", 1, 1));
  CHECK_FALSE(invariant("exp(u)", 1, 1));
  const auto linear = [](const std::string& text) {
    return linear_in_pi(Expression::parse(text, {}));
  };
  CHECK(linear("2*pi"));
  CHECK(linear("(1/3-pi)*2+pi/4"));
  CHECK_FALSE(linear("pi*pi"));
  CHECK_FALSE(linear("1/pi"));
  CHECK_FALSE(linear("e"));
  CHECK_FALSE(linear("sqrt(4)"));
}
