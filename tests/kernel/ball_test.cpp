// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/arithmetic/ball.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/arithmetic/rational.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

bool ball_holds(const Ball& b, const Rational& x) {
  return std::isfinite(b.mid) && std::isfinite(b.rad) &&
         abs(x - Rational(b.mid)) <= Rational(b.rad);
}

}  // namespace

TEST_CASE("balls hold the exact results, of numbers at their rims, too") {
  Random random(kSeed + 71);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-30, 30), share(0, 4), small(-60, -10);
  const auto draw = [&] {
    const double m = std::ldexp(mantissa(random), exponent(random));
    return Ball(m, share(random) == 0 ? 0 : std::fabs(m) * std::ldexp(1, small(random)));
  };
  const auto inside = [&](const Ball& b) {
    return Rational(b.mid) + (share(random) - 2) * Rational(b.rad) / 2;
  };
  int divided = 0;
  Failures failures;
  for (int i = 0; i < 4000 * multiplier(); ++i) {
    const Ball a = draw(), b = draw(), c = draw();
    const Rational x = inside(a), y = inside(b), z = inside(c);
    const auto expect = [&](bool holds, const char* what) {
      failures.expect(holds, what, a.mid, a.rad, b.mid, b.rad, c.mid, c.rad);
    };
    expect(ball_holds(a + b, x + y), "a + b");
    expect(ball_holds(a - b, x - y), "a - b");
    expect(ball_holds(a * b, x * y), "a b");
    expect(ball_holds(a * b - c * a + b * c, x * y - z * x + y * z), "a b - c a + b c");
    const Ball q = (a - b) / c;
    if (std::isfinite(q.rad)) {
      ++divided;
      expect(ball_holds(q, (x - y) / z), "(a - b) / c");
    }
    const Ball r = sqrt(a * a + b * b);
    if (std::isfinite(r.rad)) {
      const Rational low = Rational(r.mid) - Rational(r.rad),
                     high = Rational(r.mid) + Rational(r.rad);
      expect((low < 0 || low * low <= x * x + y * y) && x * x + y * y <= high * high,
             "the root of a a + b b");
    }
    const MaybeSign s = certain_sign(a * b - c);
    if (s) expect(*s == sign_of(Rational(x * y - z)), "the sign of a b - c");
  }
  CHECK(failures.report() == "");
  CHECK(divided > 3000 * multiplier());
}

TEST_CASE("balls that are undefined or too large have no sign") {
  const Ball zero(0.0, 1e-3), huge(1e300);
  CHECK(!certain_sign(Ball(1) / zero));
  CHECK(!certain_sign(huge * huge));
  CHECK(!certain_sign(huge * huge - huge * huge));
  CHECK(!certain_sign(sqrt(Ball(-1))));
  CHECK(!certain_sign(zero));
  CHECK(certain_sign(Ball(0)) == Sign::zero);
  // What underflows is not taken for zero.
  CHECK(!certain_sign(Ball(1e-200) * Ball(1e-200)));
}
