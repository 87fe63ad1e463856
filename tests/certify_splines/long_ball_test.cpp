// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/long_ball.hpp"

#include <catch2/catch.hpp>
#include <cfenv>
#include <limits>

#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace {

using crest::certify::spline_rays::certain_sign;
using crest::certify::spline_rays::LongBall;
using crest::kernel::MaybeSign;
using crest::kernel::Rational;
using crest::kernel::sign_of;
using namespace crest::tests;

/// By doubles that add up to it: of 113 digits two do not.
Rational exactly(long double x) {
  Rational sum = 0;
  while (x != 0) {
    const auto part = static_cast<double>(x);
    sum += Rational(part);
    x -= part;
  }
  return sum;
}
bool holds(const LongBall& b, const Rational& x) {
  return std::isfinite(b.mid) && std::isfinite(b.rad) && abs(x - exactly(b.mid)) <= exactly(b.rad);
}

using Results = std::array<LongBall, 6>;
Results results(const LongBall& a, const LongBall& b, const LongBall& c) {
  return {a + b, a - b, a * b, a * b - c * a + b * c, (a - b) / c, a * b - c};
}

class RoundingMode {
 public:
  explicit RoundingMode(int mode) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(before_); }

 private:
  int before_ = std::fegetround();
};

}  // namespace

TEST_CASE("long balls hold the exact results in every rounding mode, at their rims, too") {
  Random random(kSeed + 72);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-30, 30), share(0, 4), small(-80, -10);
  const auto draw = [&] {
    const long double m = std::ldexp(mantissa(random), exponent(random));
    return LongBall(m + std::ldexp(static_cast<long double>(mantissa(random)), -90),
                    share(random) == 0 ? 0 : std::fabs(m) * std::ldexp(1.0L, small(random)));
  };
  const auto inside = [&](const LongBall& b) {
    return Rational(exactly(b.mid) + (share(random) - 2) * exactly(b.rad) / 2);
  };
  // Volatile: no operation may leave the guard.
  Results (*volatile call)(const LongBall&, const LongBall&, const LongBall&) = results;
  int divided = 0, decided = 0, failures = 0;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for (int i = 0; i < 1500 * multiplier(); ++i) {
      const LongBall a = draw(), b = draw(), c = draw();
      const Rational x = inside(a), y = inside(b), z = inside(c);
      Results r;
      {
        const RoundingMode guard(mode);
        r = call(a, b, c);
      }
      failures += !holds(r[0], x + y) + !holds(r[1], x - y) + !holds(r[2], x * y);
      failures += !holds(r[3], x * y - z * x + y * z);
      failures += !holds(LongBall(x), x) + !holds(LongBall(Rational(x / 3)), x / 3);
      if (std::isfinite(r[4].rad)) {
        ++divided;
        failures += !holds(r[4], (x - y) / z);
      }
      const MaybeSign s = certain_sign(r[5]);
      decided += s.has_value();
      if (s) failures += *s != sign_of(Rational(x * y - z));
    }
  CHECK(failures == 0);
  CHECK(divided > 4000 * multiplier());
  CHECK(decided > 4000 * multiplier());
}

TEST_CASE("long balls that are undefined or too large have no sign") {
  const LongBall zero(0.0L, 1e-3L), huge(std::numeric_limits<long double>::max(), 0);
  CHECK(!certain_sign(LongBall(1) / zero));
  CHECK(!certain_sign(LongBall(1) / zero * LongBall(0)));
  CHECK(!certain_sign(huge * huge));
  CHECK(!certain_sign(huge * huge - huge * huge));
  CHECK(!certain_sign(LongBall(HUGE_VAL)));
  Rational beyond(0x1p1000);
  beyond *= beyond;
  CHECK(!certain_sign(LongBall(beyond)));
  CHECK(!certain_sign(LongBall(Rational(1 / beyond))));
  CHECK(certain_sign(LongBall(Rational(1) / 3)) == crest::kernel::Sign::positive);
  CHECK(certain_sign(LongBall(0.0)) == crest::kernel::Sign::zero);
}

TEST_CASE("what overflows in long balls has no sign in any rounding mode") {
  const long double top = std::ldexp(1.0L, std::numeric_limits<long double>::max_exponent - 1);
  const LongBall x(1.5L * top, 0), y(1.75L * top, 0), z(top, 0), zero(0.0L, 0);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const RoundingMode guard(mode);
    CHECK(!certain_sign(x + x - y - z));
    CHECK(!certain_sign(zero - x - x + y + z));
    CHECK(!certain_sign(x * x - y * y));
  }
}
