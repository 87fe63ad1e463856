// SPDX-License-Identifier: GPL-3.0-or-later
// When moving vectors are opposite: against algebraic numbers, the laws, the ties.
#include "kernel/predicates/turn_in_time.hpp"

#include "kernel/polynomial/real_roots.hpp"
#include "kernel/predicates/quadratic_root_order.hpp"
#include "tests/kernel/ladder_checks.hpp"
#include "tests/kernel/polynomials.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

MovingPair draw_pair(Draw& d, Family family) {
  MovingPair p;
  for (Vec2* v : {&p.a0, &p.a1, &p.b0, &p.b1}) *v = {draw(d, family), draw(d, family)};
  return p;
}
MovingPair small_pair(Draw& d) {
  MovingPair p;
  for (Vec2* v : {&p.a0, &p.a1, &p.b0, &p.b1})
    for (double& x : *v) x = d.integer(-3, 3);
  return p;
}
IntegerPolynomial as_polynomial(const QuadraticOf<double>& q) {
  return *IntegerPolynomial::from(std::vector<double>{q.c, q.b, q.a});
}

}  // namespace

TEST_CASE("turn in time: depths are what the formulas say") {
  CHECK(TurnInTime{}.value<Depth>().b.count <= TurnInTime::depth);
  CHECK(DotInTime{}.value<Depth>().b.count <= DotInTime::depth);
}

TEST_CASE("turn in time: opposite times agree with algebraic numbers") {
  Draw d(5520);
  int crossings = 0, ties = 0;
  for (std::uint64_t i = 0; i < scaled(4000); ++i) {
    const MovingPair p = small_pair(d);
    const auto turn = TurnInTime{p}.value<double>();  // exact: small integers
    if (turn.a == 0 && turn.b == 0 && turn.c == 0) continue;
    const auto dot = as_polynomial(DotInTime{p}.value<double>());
    const OppositeTimes times = opposite_times(p);
    int expected = 0;
    bool tied = turn.c == 0 && DotInTime{p}.value<double>().c <= 0;
    tied = tied || (turn.a == 0 && DotInTime{p}.value<double>().a <= 0);
    for (const RealRoot& r : real_roots(as_polynomial(turn)).roots) {
      if (sign_at(as_polynomial(QuadraticOf<double>{0, 1, 0}), r.value).sign != Sign::positive)
        continue;
      const Sign s = sign_at(dot, r.value).sign;
      if (s == Sign::positive) continue;
      if (s == Sign::zero || r.multiplicity > 1)
        tied = true;
      else
        ++expected;
    }
    CAPTURE(i, turn.a, turn.b, turn.c);
    REQUIRE(times.tied == tied);
    REQUIRE(times.count == expected);
    crossings += expected;
    ties += tied ? 1 : 0;
  }
  CHECK((crossings > 100 && ties > 100));
}

TEST_CASE("turn in time: laws") {
  for (const Family family : kFamilies) {
    Draw d(5530 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(300); ++i) {
      const MovingPair p = draw_pair(d, family);
      const OppositeTimes t = opposite_times(p), swapped = opposite_times({p.b0, p.b1, p.a0, p.a1}),
                          back = opposite_times({p.a1, p.a0, p.b1, p.b0});
      REQUIRE((swapped.count == t.count && swapped.tied == t.tied));
      REQUIRE((back.count == t.count && back.tied == t.tied));
      for (std::size_t k = 0; k < static_cast<std::size_t>(t.count); ++k) {
        REQUIRE((t.times[k] >= 0 && t.times[k] <= 1));
        REQUIRE(event_order(p, t.roots[k], p, t.roots[k]) == Sign::zero);
        REQUIRE(event_order(p, t.roots[k], {p.b0, p.b1, p.a0, p.a1}, t.roots[k]) == Sign::zero);
      }
      if (t.count == 2) REQUIRE(event_order(p, t.roots[0], p, t.roots[1]) == Sign::negative);
    }
  }
}

TEST_CASE("turn in time: a vector that vanishes half-way ties") {
  // v = (1, 0), v_s = (-1, 0): zero at t = 1/2.
  CHECK(opposite_times({{1, 0}, {-1, 0}, {0.5, 1}, {0.5, 2}}).tied);
  // Parallel at all times, but always the same way.
  const OppositeTimes t = opposite_times({{1, 0}, {2, 0}, {3, 0}, {1, 0}});
  CHECK((!t.tied && t.count == 0));
  CHECK(opposite_times({{1, 0}, {2, 0}, {-3, 0}, {1, 0}}).tied);
}
