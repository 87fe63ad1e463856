// SPDX-License-Identifier: GPL-3.0-or-later
// Signs at roots of quadratics: every stage and law, against algebraic numbers.
#include "kernel/polynomial/real_roots.hpp"
#include "kernel/predicates/quadratic_root_order.hpp"
#include "tests/kernel/ladder_checks.hpp"
#include "tests/kernel/polynomials.hpp"
#include "tests/support/failures.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

Quadratic draw_quadratic(Draw& d, Family family) {
  return {draw(d, family), draw(d, family), draw(d, family)};
}
std::vector<AlgebraicNumber> roots_of(const Quadratic& p) {
  std::vector<AlgebraicNumber> r;
  for (RealRoot& x : real_roots(*IntegerPolynomial::from(std::vector<double>{p.c, p.b, p.a})).roots)
    r.push_back(std::move(x.value));
  return r;
}
IntegerPolynomial as_polynomial(const Quadratic& p) {
  return *IntegerPolynomial::from(std::vector<double>{p.c, p.b, p.a});
}
constexpr QuadraticRoot kBoth[] = {QuadraticRoot::smaller, QuadraticRoot::larger};

}  // namespace

TEST_CASE("quadratic roots: depths are what the formulas say") {
  const Quadratic p{1, 2, 3}, q{4, 5, 6};
  require_depth(QuadraticDiscriminant<Quadratic>{p});
  require_depth(RootSlope<Quadratic, Quadratic>{{p, q}});
  require_depth(RootRationalPart<Quadratic, Quadratic>{{p, q}});
  require_depth(RootResultant<Quadratic, Quadratic>{{p, q}});
  require_depth(AtLinearRoot<Quadratic, Quadratic>{{p, q}});
  // Coefficients with a depth of their own never have less than it.
  using Slope = QuadraticSlope<Quadratic>;
  const RootResultant<Slope, Slope> deep{{Slope{p}, Slope{q}}};
  CHECK(RootResultant<Slope, Slope>::depth >= deep.value<Depth>().count);
}

TEST_CASE("quadratic roots: signs, order and number agree with algebraic numbers") {
  StageCounts generic;
  std::size_t zeros = 0, ties = 0;
  for (const Family family : kFamilies) {
    Draw d(870 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(400); ++i) {
      const Quadratic p = draw_quadratic(d, family);
      // A multiple of p, or one that shares a root where there are integers.
      Quadratic q = draw_quadratic(d, family);
      if (i % 7 == 0) q = {-2 * p.a, -2 * p.b, -2 * p.c};
      const auto pr = roots_of(p), qr = roots_of(q);
      CAPTURE(static_cast<int>(family), i, p.a, p.b, p.c, q.a, q.b, q.c);
      for (const QuadraticRoot k : kBoth) {
        const auto s = sign_at_root(p, k, q);
        REQUIRE(s.has_value() == !pr.empty());
        if (!s) continue;
        const AlgebraicNumber& r = k == QuadraticRoot::smaller ? pr.front() : pr.back();
        REQUIRE(s->sign == sign_at(as_polynomial(q), r).sign);
        zeros += s->sign == Sign::zero;
        if (family == Family::generic && i % 7 != 0) generic.add(s->stage);
        for (const QuadraticRoot m : kBoth) {
          const auto order = root_order(p, k, q, m);
          REQUIRE(order.has_value() == !qr.empty());
          if (!order) continue;
          REQUIRE(order->sign == compare(r, m == QuadraticRoot::smaller ? qr.front() : qr.back()));
          REQUIRE(order->sign == -root_order(q, m, p, k)->sign);
          ties += order->sign == Sign::zero;
        }
      }
    }
  }
  CHECK(generic.calls > 50);
  CHECK(generic.interval + generic.exact == 0);
  CHECK(zeros > 100);
  CHECK(ties > 100);
}

TEST_CASE("quadratic roots: laws") {
  Draw d(880);
  for (std::uint64_t i = 0; i < scaled(5000); ++i) {
    const Quadratic p = draw_quadratic(d, Family::small_integers);
    const Quadratic q = draw_quadratic(d, Family::small_integers);
    const Quadratic times{3 * p.a, 3 * p.b, 3 * p.c}, minus{-p.a, -p.b, -p.c};
    const Quadratic minus_q{-q.a, -q.b, -q.c};
    const Quadratic mirrored_p{p.a, -p.b, p.c}, mirrored_q{q.a, -q.b, q.c};
    for (const QuadraticRoot k : kBoth) {
      const auto s = sign_at_root(p, k, q);
      const auto same = [&](const std::optional<Decision>& t, int factor) {
        return t.has_value() == s.has_value() &&
               (!s || static_cast<int>(t->sign) == factor * static_cast<int>(s->sign));
      };
      const QuadraticRoot other =
          k == QuadraticRoot::smaller ? QuadraticRoot::larger : QuadraticRoot::smaller;
      REQUIRE(same(sign_at_root(times, k, q), 1));
      REQUIRE(same(sign_at_root(minus, k, q), 1));
      REQUIRE(same(sign_at_root(p, k, minus_q), -1));
      REQUIRE(same(sign_at_root(mirrored_p, other, mirrored_q), 1));
      if (s) REQUIRE(sign_at_root(p, k, p)->sign == Sign::zero);
    }
  }
}

TEST_CASE("quadratic roots: the stage that decides") {
  const Quadratic two{1, 0, -2};
  const auto at = [&](const Quadratic& q) { return *sign_at_root(two, QuadraticRoot::larger, q); };
  CHECK(at({0, 1, -1}).stage == Stage::triage);
  CHECK(at({0, 1, -1}).sign == Sign::positive);
  CHECK(at({3, 0, -6}).sign == Sign::zero);
  // sqrt(2) and the doubles on both sides.
  const double below = 1.4142135623730949, above = 1.4142135623730951;
  CHECK(at({0, 1, -below}).sign == Sign::positive);
  CHECK(at({0, 1, -above}).sign == Sign::negative);
  CHECK(at({0, 1, -above}).stage != Stage::triage);
  CHECK(discriminant_sign(Quadratic{1, 2, 1}).sign == Sign::zero);
  CHECK(discriminant_sign(Quadratic{1, 2, 1}).stage == Stage::interval);
  CHECK(discriminant_sign(Quadratic{1, 2, 2}).sign == Sign::negative);
  CHECK(discriminant_sign(Quadratic{1.1, 2.2, 1.1}).stage == Stage::exact);
  CHECK_FALSE(sign_at_root(Quadratic{0, 0, 1}, QuadraticRoot::larger, two));
}

TEST_CASE("quadratic roots: stages agree on the degenerate families") {
  for (const Family family : kFamilies) {
    Draw d(890 + static_cast<std::uint64_t>(family));
    CAPTURE(static_cast<int>(family));
    require_stages_agree<QuadraticDiscriminant<Quadratic>>(scaled(500), [&](std::uint64_t) {
      return QuadraticDiscriminant<Quadratic>{draw_quadratic(d, family)};
    });
    require_stages_agree<RootResultant<Quadratic, Quadratic>>(scaled(500), [&](std::uint64_t) {
      return RootResultant<Quadratic, Quadratic>{
          {draw_quadratic(d, family), draw_quadratic(d, family)}};
    });
    Failures failures;
    for (std::uint64_t i = 0; i < scaled(200); ++i) {
      const Quadratic p = draw_quadratic(d, family), q = draw_quadratic(d, family);
      failures.expect(bound_holds(RootResultant<Quadratic, Quadratic>{{p, q}}),
                      "the bound of a resultant", p.a, p.b, p.c, q.a, q.b, q.c);
    }
    CHECK(failures.report() == "");
  }
}
