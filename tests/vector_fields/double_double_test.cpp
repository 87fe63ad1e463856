// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of doubles against rationals.
#include "algorithms/vector_fields/double_double.hpp"

#include <catch2/catch.hpp>

#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Rational;
using vector_fields::DoubleDouble;

namespace {

Rational value(const DoubleDouble& x) {
  const double high = static_cast<double>(x);
  return Rational(high) + Rational(static_cast<double>(x - high));
}
/// About 106 random bits.
DoubleDouble draw(Random& random) {
  const auto part = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5; };
  return ldexp(DoubleDouble(part()) + part() * 0x1p-53, static_cast<int>(random() % 80) - 40);
}

}  // namespace

TEST_CASE("pairs of doubles: relative errors below 2^-102") {
  Random random(kSeed);
  const Rational unit(0x1p-102);
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    const DoubleDouble x = draw(random), y = draw(random);
    const Rational a = value(x), b = value(y);
    CHECK(abs(value(x * y) - a * b) <= unit * abs(a * b));
    CHECK(abs(value(x / y) - a / b) <= unit * abs(a / b));
    // Also where much cancels.
    CHECK(abs(value(x + y) - (a + b)) <= unit * abs(a + b));
    CHECK(abs(value(x - y) - (a - b)) <= unit * abs(a - b));
    const DoubleDouble near = x * (1 + ldexp(DoubleDouble(1), -70));
    CHECK(abs(value(near - x) - (value(near) - a)) <= unit * abs(value(near) - a));
    const Rational root = value(sqrt(fabs(x)));
    CHECK(abs(root * root - abs(a)) <= 4 * unit * abs(a));
    CHECK((x < y) == (a < b));
    CHECK(DoubleDouble(a) == x);
  }
}
