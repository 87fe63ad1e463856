// SPDX-License-Identifier: GPL-3.0-or-later
// Root isolation: known roots, laws, degenerate families, who decided.
#include <catch2/catch.hpp>
#include <limits>

#include "kernel/polynomial/common_divisor.hpp"
#include "kernel/polynomial/descartes.hpp"
#include "kernel/polynomial/real_roots.hpp"
#include "tests/kernel/polynomials.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

// Roots and multiplicities must be these, in this order.
void require_roots(const RealRoots& found, const std::vector<Rooted>& expected) {
  REQUIRE(found.roots.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK(compare(found.roots[i].value, expected[i].r) == Sign::zero);
    CHECK(found.roots[i].multiplicity == expected[i].m);
  }
}

IntegerPolynomial negated(const IntegerPolynomial& p) {
  return IntegerPolynomial() - p;
}

// Laws 1 to 4 of real_roots.hpp.
bool laws_hold(const IntegerPolynomial& p) {
  const RealRoots r = real_roots(p);
  int sum = 0;
  for (std::size_t i = 0; i < r.roots.size(); ++i) {
    sum += r.roots[i].multiplicity;
    if (i > 0 && compare(r.roots[i - 1].value, r.roots[i].value) != Sign::negative) return false;
    if (sign_at(p, r.roots[i].value).sign != Sign::zero) return false;
    IntegerPolynomial d = p;
    for (int k = 1; k <= r.roots[i].multiplicity; ++k) {
      d = d.derivative();
      const Sign s = sign_at(d, r.roots[i].value).sign;
      if ((s == Sign::zero) != (k < r.roots[i].multiplicity)) return false;
    }
  }
  if ((sum - p.degree()) % 2 != 0 || sum > p.degree()) return false;
  const RealRoots same = real_roots(negated(p) * polynomial({6})), back = real_roots(p.mirrored());
  if (same.roots.size() != r.roots.size() || back.roots.size() != r.roots.size()) return false;
  for (std::size_t i = 0; i < r.roots.size(); ++i) {
    const RealRoot& x = r.roots[i];
    const RealRoot& y = back.roots[r.roots.size() - 1 - i];
    if (compare(same.roots[i].value, x.value) != Sign::zero) return false;
    if (same.roots[i].multiplicity != x.multiplicity || y.multiplicity != x.multiplicity)
      return false;
    // -y is a root of p, and the brackets of x and -y overlap.
    if (sign_at(p.mirrored(), y.value).sign != Sign::zero) return false;
    const auto bx = x.value.bracket(), by = y.value.bracket();
    if (bx.low > -by.low || bx.high < -by.high) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("polynomial roots: zero, constants, powers") {
  CHECK(real_roots({}).everywhere);
  CHECK(unit_roots(IntegerPolynomial()).everywhere);
  CHECK_FALSE(real_roots(polynomial({7})).everywhere);
  CHECK(real_roots(polynomial({-7})).roots.empty());
  require_roots(real_roots(polynomial({0, 0, 0, -5})), {{0, 3}});
  require_roots(real_roots(polynomial({1, 3})), {{Rational(-1, 3), 1}});
  CHECK(real_roots(polynomial({1, 0, 1})).roots.empty());
  CHECK(real_roots(polynomial({1, 0, 2, 0, 1})).roots.empty());  // double complex roots
}

TEST_CASE("polynomial roots: given roots come back with their multiplicities") {
  const std::vector<std::vector<Rooted>> cases = {
      {{-2, 2}, {0, 3}, {Rational(1, 3), 1}, {5, 4}},
      {{Rational(-1, 7), 5}},
      {{Rational(1, 3), 2}, {Rational(1, 2), 2}, {Rational(2, 3), 1}, {Rational(3, 4), 3}},
      {{-1, 1}, {0, 1}, {1, 1}},
      {{Rational(Integer(1) << 400), 1}, {(Integer(1) << 400) + 1, 2}},
  };
  for (const auto& roots : cases) {
    require_roots(real_roots(with_roots(roots)), roots);
    require_roots(real_roots(with_roots(roots) * polynomial({1, 1, 1})), roots);
  }
}

TEST_CASE("polynomial roots: the open unit interval leaves its ends out") {
  const auto p = with_roots({{-1, 1}, {0, 2}, {Rational(1, 3), 1}, {Rational(1, 2), 2}, {1, 1}});
  require_roots(unit_roots(p), {{Rational(1, 3), 1}, {Rational(1, 2), 2}});
  require_roots(unit_roots(with_roots({{0, 1}, {1, 1}})), {});
  // A simple root at an end and one close to it.
  const Rational tiny(1, Integer(1) << 2000);
  require_roots(unit_roots(with_roots({{0, 1}, {tiny, 1}})), {{tiny, 1}});
  require_roots(unit_roots(with_roots({{1 - tiny, 1}, {1, 1}})), {{1 - tiny, 1}});
}

TEST_CASE("polynomial roots: clusters, Wilkinson, Mignotte, Chebyshev") {
  const Rational close = Rational(1, pow(Integer(10), 300));
  const std::vector<Rooted> cluster = {
      {Rational(1, 3), 1}, {Rational(1, 3) + close, 2}, {Rational(1, 3) + 2 * close, 1}};
  require_roots(real_roots(with_roots(cluster)), cluster);
  require_roots(unit_roots(with_roots(cluster)), cluster);
  // The same cluster inside one square-free factor.
  const std::vector<Rooted> simple = {
      {Rational(1, 3), 1}, {Rational(1, 3) + close, 1}, {Rational(1, 3) + 2 * close, 1}};
  require_roots(real_roots(with_roots(simple)), simple);

  std::vector<Rooted> integers;
  for (int k = 1; k <= 24; ++k) integers.push_back({k, 1});
  require_roots(real_roots(wilkinson(24)), integers);

  for (const int n : {5, 9, 16}) {
    const RealRoots r = real_roots(mignotte(n, Integer(1) << 40));
    CHECK(r.roots.size() == (n % 2 == 0 ? 4 : 3));
    const Sign s = compare(r.roots[n % 2 == 0 ? 1 : 0].value, r.roots[n % 2 == 0 ? 2 : 1].value);
    CHECK(s == Sign::negative);
  }
  for (const int n : {4, 9, 16, 31}) CHECK(real_roots(chebyshev(n)).roots.size() == std::size_t(n));
}

TEST_CASE("polynomial roots: laws on random families") {
  for (const Family family : kFamilies) {
    Draw d(700 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(100); ++i) {
      const IntegerPolynomial p = draw_polynomial(d, family, d.integer(1, 8));
      if (p.is_zero()) continue;
      CAPTURE(static_cast<int>(family), i);
      REQUIRE(laws_hold(p));
    }
  }
  Draw d(710);
  for (std::uint64_t i = 0; i < scaled(300); ++i) {
    const IntegerPolynomial p = draw_product(d);
    CAPTURE(i);
    REQUIRE(laws_hold(p));
  }
}

TEST_CASE("polynomial roots: infinities and NaN are refused, denormals are not") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  for (const double bad : {inf, -inf, nan}) {
    CHECK_FALSE(IntegerPolynomial::from(std::vector<double>{1, bad}));
    CHECK_FALSE(unit_roots(std::vector<double>{1, bad, -1}));
  }
  CHECK(unit_roots(std::vector<double>{0, 0, 0})->everywhere);
  // Bernstein coefficients -least, most: the root is least / (least + most).
  const auto r = unit_roots(std::vector<double>{-least, most});
  REQUIRE(r);
  require_roots(*r, {{Rational(least) / (Rational(least) + Rational(most)), 1}});
  require_roots(*unit_roots(std::vector<double>{-least, least}), {{Rational(1, 2), 1}});
  // x^2 - least^2 and most x^2 - least.
  CHECK(real_roots(*IntegerPolynomial::from(std::vector<double>{-least, 0, most})).roots.size() ==
        2);
}

TEST_CASE("polynomial roots: places of triage and of the exact stage hold the same roots") {
  std::size_t decided = 0, all = 0, roots = 0;
  for (const Family family : kFamilies) {
    Draw d(720 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(1000); ++i) {
      std::vector<double> b;
      for (int k = d.integer(1, 12); k >= 0; --k) b.push_back(draw(d, family));
      const auto whole = IntegerPolynomial::from_bernstein(*integers(b));
      if (whole.is_zero()) continue;
      ++all;
      const auto places = triage_unit_places(b, 0);
      if (!places) continue;
      ++decided;
      roots += places->size();
      CAPTURE(static_cast<int>(family), i);
      const auto factors = square_free_factors(whole);
      std::vector<UnitPlace> exact;
      for (const auto& f : factors) {
        const auto more = exact_unit_places(bernstein_coefficients(f.p));
        if (!more.empty()) REQUIRE(f.multiplicity == 1);
        exact.insert(exact.end(), more.begin(), more.end());
      }
      REQUIRE(exact.size() == places->size());
      double last = 0;
      for (const UnitRange& x : *places) {
        // Law 2, and law 1.
        REQUIRE(x.low >= last);
        last = x.high;
        REQUIRE(whole.sign_at(dyadic(x.low)) == -whole.sign_at(dyadic(x.high)));
        REQUIRE(whole.sign_at(dyadic(x.low)) != Sign::zero);
      }
    }
  }
  CHECK(roots > decided / 2);
  CHECK(decided > all * 3 / 4);
}

TEST_CASE("polynomial roots: a wrong coefficient within the error changes no answer of triage") {
  Draw d(730);
  for (std::uint64_t i = 0; i < scaled(3000); ++i) {
    const int n = d.integer(1, 9);
    const double error = std::ldexp(1.0, -d.integer(2, 40));
    std::vector<double> b, moved;
    std::vector<Integer> exact;
    for (int k = 0; k <= n; ++k) {
      b.push_back(d.uniform());
      // The exact coefficients differ by up to the error, in both directions.
      moved.push_back(d.coin() ? error : -error);
      exact.push_back(
          Integer((Rational(b.back()) + Rational(moved.back())) * Rational(pow(Integer(2), 200))));
    }
    const auto places = triage_unit_places(b, error);
    if (!places) continue;
    const IntegerPolynomial p = IntegerPolynomial::from_bernstein(exact);
    REQUIRE(unit_roots(p).roots.size() == places->size());
    for (const UnitRange& x : *places)
      REQUIRE(p.sign_at(dyadic(x.low)) == -p.sign_at(dyadic(x.high)));
  }
}

TEST_CASE("polynomial roots: triage decides the typical case, not the degenerate ones") {
  Draw d(740);
  std::size_t typical = 0, line = 0;
  const std::size_t all = scaled(2000);
  for (std::size_t i = 0; i < all; ++i) {
    std::vector<double> b;
    for (int k = 0; k <= 6; ++k) b.push_back(d.uniform());
    typical += unit_roots(b)->stage == Stage::triage;
    if (i % 10 == 0) line += real_roots(*IntegerPolynomial::from(b)).stage == Stage::triage;
  }
  CHECK(typical > all * 99 / 100);
  CHECK(line > all / 10 * 95 / 100);
  CHECK(real_roots(with_roots({{1, 2}})).stage == Stage::exact);
  // A root where the interval is halved.
  CHECK(unit_roots(with_roots({{Rational(1, 2), 1}, {Rational(2, 3), 1}})).stage == Stage::exact);
  CHECK(unit_roots(with_roots({{Rational(1, 3), 1}, {2, 1}})).stage == Stage::triage);
}

TEST_CASE("polynomials: divisors, quotients, square-free factors") {
  Draw d(750);
  for (std::uint64_t i = 0; i < scaled(300); ++i) {
    const IntegerPolynomial a = draw_product(d), b = draw_product(d), c = draw_product(d);
    const IntegerPolynomial g = common_divisor(a * c, b * c);
    // c divides g, g divides both, and what is left is coprime.
    REQUIRE(common_divisor(g, c) == common_divisor(c, c));
    const IntegerPolynomial u = quotient((a * c).primitive(), g),
                            v = quotient((b * c).primitive(), g);
    REQUIRE(u * g == (a * c).primitive());
    REQUIRE(v * g == (b * c).primitive());
    REQUIRE(common_divisor(u, v).degree() == 0);
    if (coprime_modulo_prime(u, v)) REQUIRE_FALSE(coprime_modulo_prime(u * c, v * polynomial({0})));
    IntegerPolynomial product = polynomial({1});
    for (const SquareFreeFactor& f : square_free_factors(a)) {
      REQUIRE(common_divisor(f.p, f.p.derivative()).degree() == 0);
      for (int m = 0; m < f.multiplicity; ++m) product = product * f.p;
    }
    REQUIRE((product == a.primitive() || negated(product) == a.primitive()));
  }
  // The prime divides both leading coefficients: nothing is learnt.
  const Integer prime = (Integer(1) << 61) - 1;
  CHECK_FALSE(coprime_modulo_prime(IntegerPolynomial({1, prime}), IntegerPolynomial({2, prime})));
  CHECK(common_divisor(IntegerPolynomial({1, prime}), IntegerPolynomial({2, prime})).degree() == 0);
}
