// SPDX-License-Identifier: GPL-3.0-or-later
// Several expressions at once: each value computed once, each result its own.
#include <bit>
#include <catch2/catch.hpp>

#include "kernel/expressions/evaluate.hpp"
#include "tests/kernel/xyz.hpp"
#include "tests/support/degenerate_families.hpp"

namespace {

using namespace crest::kernel;
using crest::tests::Draw;
using crest::tests::kXyz;

Schedule schedule_of(const std::vector<std::string>& texts) {
  std::vector<Expression> expressions;
  for (const std::string& t : texts) expressions.push_back(Expression::parse(t, kXyz));
  return schedule(expressions);
}

}  // namespace

TEST_CASE("what expressions have in common is one step") {
  CHECK(schedule_of({"x*y + x*y"}).steps.size() == 2);
  CHECK(schedule_of({"x*y + y*x"}).steps.size() == 3);
  CHECK(schedule_of({"x^4 + x^2 + x*x"}).steps.size() == 4);
  CHECK(schedule_of({"x^7"}).steps.size() == 4);
  CHECK(schedule_of({"cos(x)*sin(y)", "cos(x)*cos(y)", "cos(x)"}).steps.size() == 5);
  CHECK(schedule_of({"0.5*x + 0.50*y"}).constants.size() == 1);
  CHECK(schedule_of({"x", "3", "x^1"}).steps.empty());
  CHECK(schedule_of({"x^0 + x^(0)"}).steps.size() == 2);
}

TEST_CASE("places are used again, but not those of results") {
  std::string sum = "x";
  for (int i = 0; i < 500; ++i) sum += " + " + std::to_string(i) + "*sin(x)*y";
  const Schedule s = schedule_of({sum});
  CHECK(s.steps.size() == 1501);
  CHECK(s.places <= 5);
  for (const Schedule::Step& step : s.steps)
    for (const auto& x : {step.first, step.last})
      if (x.kind == Schedule::Operand::Kind::step) CHECK(s.steps[x.index].place != step.place);
  CHECK(schedule_of({"sin(x)", "cos(x)", "exp(x)"}).places == 3);
}

TEST_CASE("values shared by expressions are those of each on its own, to the bit") {
  Draw d(43);
  for (std::uint64_t i = 0; i < crest::tests::scaled(300); ++i) {
    std::vector<std::string> pool = {"x", "y", "z", "0.7", "pi"};
    const auto any = [&]() -> const std::string& {
      return pool[static_cast<std::size_t>(d.integer(0, static_cast<int>(pool.size()) - 1))];
    };
    for (int k = 0; k < 12; ++k) {
      const std::string a = any(), b = any();
      if (a.size() + b.size() > 2000) continue;
      switch (d.integer(0, 5)) {
        case 0:
          pool.push_back("(" + a + " + " + b + ")");
          break;
        case 1:
          pool.push_back("(" + a + " - " + b + ")");
          break;
        case 2:
          pool.push_back(a + "*" + b);
          break;
        case 3:
          pool.push_back("(" + a + ")^" + std::to_string(d.integer(-3, 6)));
          break;
        case 4:
          pool.push_back("sin(" + a + ")/(2 + " + b + ")");
          break;
        default:
          pool.push_back("-" + a);
      }
      if (pool.back().starts_with("-")) pool.back() = "(" + pool.back() + ")";
      if (d.coin()) pool.back() = "(" + pool.back() + ")";
    }
    std::vector<Expression> expressions;
    for (int k = 0; k < 4; ++k) expressions.push_back(Expression::parse(any(), kXyz));
    const std::vector<double> at = {d.uniform(), d.uniform(), d.uniform()};
    Evaluator<double> together(expressions, as_double, 1.0);
    for (int repeat = 0; repeat < 2; ++repeat) {
      const auto values = together.all<4>(at);
      for (std::size_t k = 0; k < 4; ++k) {
        INFO(expressions[k].text());
        CHECK(std::bit_cast<std::uint64_t>(values[k]) ==
              std::bit_cast<std::uint64_t>(double_evaluator(expressions[k])(at)));
      }
    }
  }
}
