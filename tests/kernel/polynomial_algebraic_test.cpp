// SPDX-License-Identifier: GPL-3.0-or-later
// Algebraic numbers: laws of comparison and of signs, whatever polynomial and interval name them.
#include <catch2/catch.hpp>

#include "kernel/polynomial/real_roots.hpp"
#include "tests/kernel/polynomials.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

AlgebraicNumber root(const IntegerPolynomial& p, double low, double high) {
  return AlgebraicNumber(std::make_shared<const IntegerPolynomial>(p), dyadic(low), dyadic(high));
}

std::vector<AlgebraicNumber> draw_numbers(Draw& d, std::size_t count) {
  std::vector<AlgebraicNumber> all;
  while (all.size() < count)
    for (const RealRoot& r : real_roots(draw_product(d)).roots) all.push_back(r.value);
  return all;
}

}  // namespace

TEST_CASE("algebraic numbers: the square root of two by many names") {
  const IntegerPolynomial two = polynomial({-2, 0, 1});
  const std::vector<AlgebraicNumber> names = {
      root(two, 1, 2), root(two * polynomial({-3, 1}), 0, 1.5),
      root(two * polynomial({-3, 0, 1}) * polynomial({-3, 0, 1}), 1, 1.5),
      root(two * polynomial({-2, 0, 0, 1}), 1.375, 1.5), root(two, 0, 8)};
  for (const AlgebraicNumber& a : names)
    for (const AlgebraicNumber& b : names) CHECK(compare(a, b) == Sign::zero);
  const AlgebraicNumber x = names[0];
  CHECK(compare(x, Rational(7, 5)) == Sign::positive);
  CHECK(compare(x, Rational(3, 2)) == Sign::negative);
  CHECK(compare(x, root(polynomial({-3, 0, 0, 1}), 1, 2)) == Sign::negative);
  CHECK(sign_at(polynomial({-2, 0, 0, 0, 0, 1}), x).sign == Sign::positive);
  CHECK(sign_at(polynomial({-4, 0, 0, 0, 1}), x).sign == Sign::zero);
  CHECK(sign_at({}, x).sign == Sign::zero);
  const auto b = x.bracket();
  CHECK((b.low < std::sqrt(2.0) || b.high > std::sqrt(2.0)));
  CHECK(b.high <= std::nextafter(std::nextafter(b.low, 2), 2));
}

TEST_CASE("algebraic numbers: order laws on numbers with common roots") {
  Draw d(760);
  std::size_t equal = 0;
  for (std::uint64_t i = 0; i < scaled(20); ++i) {
    std::vector<AlgebraicNumber> all = draw_numbers(d, 14);
    const std::vector<AlgebraicNumber> before = all;
    const auto groups = increasing_groups(all);
    std::vector<std::size_t> rank(all.size());
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t k : groups[g]) rank[k] = g;
    for (std::size_t j = 0; j < all.size(); ++j)
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Sign s = compare(before[j], before[k]);
        equal += j != k && s == Sign::zero;
        REQUIRE(s == -compare(before[k], before[j]));
        REQUIRE(s == (rank[j] < rank[k]   ? Sign::negative
                      : rank[j] > rank[k] ? Sign::positive
                                          : Sign::zero));
        REQUIRE(compare(before[j], all[j]) == Sign::zero);
      }
  }
  CHECK(equal > 50);
}

TEST_CASE("algebraic numbers: signs are multiplicative, zero exactly at common roots") {
  Draw d(770);
  std::size_t zero = 0, interval = 0, calls = 0;
  for (std::uint64_t i = 0; i < scaled(60); ++i) {
    for (const AlgebraicNumber& x : draw_numbers(d, 3)) {
      const IntegerPolynomial q = draw_product(d), r = draw_small(d, 4);
      const Decision a = sign_at(q, x), b = sign_at(r, x), c = sign_at(q * r, x);
      REQUIRE(c.sign == a.sign * b.sign);
      REQUIRE(sign_at(x.polynomial() * q, x).sign == Sign::zero);
      bool common = false;
      for (const RealRoot& y : real_roots(q).roots)
        common = common || compare(x, y.value) == Sign::zero;
      REQUIRE(common == (a.sign == Sign::zero));
      REQUIRE(sign_at(q, x.refined(300)).sign == a.sign);
      zero += a.sign == Sign::zero;
      const bool rational = AlgebraicNumber(x).find_rational();
      for (const Decision& e : {a, b, c}) {
        ++calls;
        interval += e.stage == Stage::interval;
        // Doubles never claim a zero at a number that is not rational.
        if (!rational && e.sign == Sign::zero && !r.is_zero()) REQUIRE(e.stage == Stage::exact);
      }
    }
  }
  CHECK(zero > 10);
  CHECK(interval > calls / 2);
}

TEST_CASE("algebraic numbers: signs that doubles cannot tell") {
  // x^2 - 2 and a polynomial that is 2^-400 off at its root.
  const AlgebraicNumber x = root(polynomial({-2, 0, 1}), 1, 2);
  const Rational tiny(1, Integer(1) << 400);
  for (const int side : {-1, 1}) {
    const Decision d = sign_at(polynomial({-2 + side * tiny, 0, 1}), x);
    CHECK(d.sign == sign_of(side));
    CHECK(d.stage == Stage::exact);
    CHECK(compare(x, real_roots(polynomial({-2 + side * tiny, 0, 1})).roots[1].value) ==
          sign_of(side));
  }
  CHECK(sign_at(polynomial({-1, 1}), x).stage == Stage::interval);
}

TEST_CASE("algebraic numbers: rational ones are found") {
  // A root 1/3 inside a polynomial whose other roots are not rational.
  AlgebraicNumber third = root(polynomial({-1, 3}) * polynomial({-2, 0, 1}), 0, 1);
  CHECK_FALSE(third.rational());
  CHECK(compare(third, Rational(1, 3)) == Sign::zero);
  CHECK(third.find_rational());
  CHECK(*third.rational() == Rational(1, 3));
  AlgebraicNumber negative = root(polynomial({-5, -7}) * polynomial({-2, 0, 1}), -1, 0);
  CHECK(negative.find_rational());
  CHECK(*negative.rational() == Rational(-5, 7));
  AlgebraicNumber none = root(polynomial({-2, 0, 1}), 1, 2);
  CHECK_FALSE(none.find_rational());
  CHECK(none.bracket().low < none.bracket().high);
  CHECK(AlgebraicNumber(Rational(1, 2)).bracket().low == 0.5);
  CHECK(AlgebraicNumber(Rational(1, 2)).bracket().high == 0.5);
  const auto b = AlgebraicNumber(Rational(1, 3)).bracket();
  CHECK((b.low < b.high && compare(dyadic(b.low), Rational(1, 3)) == Sign::negative &&
         compare(dyadic(b.high), Rational(1, 3)) == Sign::positive));
  // A root at zero that nobody knows to be zero, and one below the least double.
  AlgebraicNumber zero = root(polynomial({0, 3, 0, 1}), -0.75, 2);
  CHECK(zero.bracket().low <= 0);
  CHECK(zero.bracket().high >= 0);
  const Rational tiny(1, Integer(1) << 3000);
  const auto least = real_roots(polynomial({-2 * tiny, 0, 1})).roots[1].value.bracket();
  CHECK(least.low == 0);
  CHECK(least.high > 0);
}

TEST_CASE("algebraic numbers: refinement keeps the root and doubles its bits") {
  Draw d(780);
  for (std::uint64_t i = 0; i < scaled(100); ++i)
    for (const AlgebraicNumber& x : draw_numbers(d, 2))
      for (const long bits : {3L, 60L, 1000L}) {
        const AlgebraicNumber y = x.refined(bits);
        REQUIRE(y.width_bits() >= bits);
        if (y.rational()) {
          REQUIRE(x.polynomial().sign_at(*y.rational()) == Sign::zero);
          continue;
        }
        REQUIRE(compare(y.low(), x.low()) != Sign::negative);
        REQUIRE(compare(y.high(), x.high()) != Sign::positive);
        REQUIRE(x.polynomial().sign_at(y.low()) == -x.polynomial().sign_at(y.high()));
      }
}

TEST_CASE("dyadic numbers: doubles, order, brackets") {
  for (const Family family : kFamilies) {
    Draw d(790 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(300); ++i) {
      const double x = draw(d, family), y = draw(d, family);
      const Dyadic a = dyadic(x), b = dyadic(y);
      REQUIRE(a.value() == Rational(x));
      REQUIRE(a.lower() == x);
      REQUIRE(a.upper() == x);
      REQUIRE(compare(a, b) == sign_of(x - y));
      REQUIRE((a + b).value() == Rational(x) + Rational(y));
      REQUIRE((a - b).value() == Rational(x) - Rational(y));
      REQUIRE(compare(a, Rational(y)) == sign_of(x - y));
      REQUIRE(Rational((a + b).lower()) <= (a + b).value());
      REQUIRE(Rational((a + b).upper()) >= (a + b).value());
      REQUIRE(middle(a, b).value() * 2 == Rational(x) + Rational(y));
    }
  }
}
