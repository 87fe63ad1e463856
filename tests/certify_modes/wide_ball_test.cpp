// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of doubles with a radius hold what rationals find.
#include "certify/modes_curves/wide_ball.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kernel/arithmetic/rational.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"

using crest::certify::curves::WideBall;
using crest::kernel::Rational;
using namespace crest::tests;

namespace {

/// A ball and a number that it holds.
struct Held {
  WideBall ball;
  Rational number;

  bool holds() const {
    const Rational distance = Rational(abs(number - Rational(ball.hi) - Rational(ball.lo)));
    return std::isfinite(ball.rad) && distance <= Rational(ball.rad) &&
           std::fabs(ball.lo) <= 0x1p-52 * std::fabs(ball.hi);
  }
};

Held random_held(Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto sized = [&](int least, int most) {
    return std::ldexp(unit(random), least + static_cast<int>(random() % (most - least + 1U)));
  };
  const double hi = sized(-60, 60);
  double lo = random() % 4 == 0 ? 0 : hi * 0x1p-54 * unit(random);
  if (hi + lo != hi) lo = 0;
  const double radius =
      random() % 3 == 0 ? 0 : std::fabs(hi) * std::ldexp(1.0, -static_cast<int>(random() % 130));
  // Often at the end of the ball.
  const double part = random() % 2 == 0 ? (random() % 2 == 0 ? 1 : -1) : unit(random);
  return {{hi, lo, radius}, Rational(hi) + Rational(lo) + Rational(radius) * Rational(part)};
}

}  // namespace

TEST_CASE("modes-curves: pairs of doubles hold the exact results") {
  Random random(kSeed);
  Failures failures;
  double widest = 0;
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    Held a = random_held(random), b = random_held(random);
    if (random() % 4 == 0) b = {-a.ball, -a.number};  // cancels
    if (random() % 4 == 0) b.ball = b.ball + WideBall(-a.ball.hi), b.number -= Rational(a.ball.hi);
    failures.expect(Held{a.ball + b.ball, a.number + b.number}.holds(), "sum", a.ball.hi,
                    b.ball.hi);
    failures.expect(Held{a.ball - b.ball, a.number - b.number}.holds(), "difference", a.ball.hi,
                    b.ball.hi);
    failures.expect(Held{a.ball * b.ball, a.number * b.number}.holds(), "product", a.ball.hi,
                    b.ball.hi);
    if (sign_of(b.ball) != 0) {
      const WideBall quotient = a.ball / b.ball;
      failures.expect(Held{quotient, Rational(a.number / b.number)}.holds(), "quotient", a.ball.hi,
                      b.ball.hi);
      if (a.ball.rad == 0 && b.ball.rad == 0 && a.ball.hi != 0)
        widest = std::max(widest, quotient.rad / std::fabs(quotient.hi));
    }
    failures.expect(sign_of(a.ball) == 0 || (sign_of(a.ball) > 0) == (a.number > 0), "sign",
                    a.ball.hi, a.ball.rad);
  }
  CHECK(failures.report() == "");
  CHECK(widest < 0x1p-95);
}

TEST_CASE("modes-curves: nothing is certain of what overflowed or is undefined") {
  const WideBall big(0x1p1000), zero(0.0), ball(1, 0, 2);
  for (const WideBall& x :
       {big * big, big * big - big * big, WideBall(1) / zero, WideBall(1) / ball, zero / zero,
        WideBall(HUGE_VAL) - WideBall(1), WideBall(std::nan("")) * WideBall(2), ball, zero}) {
    CAPTURE(x.hi, x.lo, x.rad);
    CHECK(sign_of(x) == 0);
    CHECK(sign_of(-x) == 0);
  }
}
