// SPDX-License-Identifier: GPL-3.0-or-later
// exp, sin and cos against MPFR: within their stated errors, which are small.
#include "kernel/arithmetic/elementary.hpp"

#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/failures.hpp"

using namespace crest::kernel;

namespace {

/// |exact - value| <= error, exactly.
template <class Function>
bool holds(Function function, double x, const Approximation& y) {
  mpfr_t exact, difference;
  mpfr_inits2(300, exact, difference, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(exact, x, MPFR_RNDN);
  function(exact, exact, MPFR_RNDN);
  mpfr_sub_d(difference, exact, y.value, MPFR_RNDN);
  mpfr_abs(difference, difference, MPFR_RNDN);
  const bool within = mpfr_cmp_d(difference, y.error) <= 0;
  mpfr_clears(exact, difference, static_cast<mpfr_ptr>(nullptr));
  return within;
}

/// Numbers of all sizes, near multiples of `period` (where k changes and sin or cos vanish) and
/// plain ones.
std::vector<double> arguments(double largest, double period) {
  crest::tests::Random random(1980);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> all = {0,       0x1p-1074, 1e-320, 1e-300,  -1e-300,
                             0x1p-30, 1,         -1,     largest, -largest};
  const auto count = static_cast<int>(std::fmin(largest / period, 4000));
  for (int k = -count; k <= count; ++k)
    for (const double part : {k / 2.0 - 1e-16, k / 2.0, k / 2.0 + 1e-9}) {
      const double x = period * part;
      for (const double y : {std::nextafter(x, -1e9), x, std::nextafter(x, 1e9)})
        if (std::fabs(y) <= largest) all.push_back(y);
    }
  for (int i = 0; i < 15000; ++i) {
    all.push_back(largest * unit(random));
    all.push_back(2 * unit(random));
    all.push_back(std::ldexp(unit(random), static_cast<int>(random() % 60) - 50));
  }
  return all;
}

}  // namespace

TEST_CASE("exp is within its error") {
  crest::tests::Failures failures;
  for (const double x : arguments(700, std::log(2))) {
    const auto y = exp_near(x);
    failures.expect(holds(mpfr_exp, x, y), "exp is within its error at", x);
    failures.expect(y.error <= 0x1p-51 * y.value, "the error of exp is small at", x);
  }
  CHECK(failures.report() == "");
}

TEST_CASE("sin and cos are within their errors") {
  crest::tests::Failures failures;
  for (const double x : arguments(0x1p19, std::acos(-1))) {
    const auto [s, c] = sin_cos_near(x);
    failures.expect(holds(mpfr_sin, x, s), "sin is within its error at", x);
    failures.expect(holds(mpfr_cos, x, c), "cos is within its error at", x);
    failures.expect(s.error <= 0x1p-51 && c.error <= 0x1p-51, "the errors are small at", x);
  }
  CHECK(failures.report() == "");
  CHECK(sin_cos_near(0)[0].value == 0);
  CHECK(sin_cos_near(0)[0].error == 0);
}

TEST_CASE("beyond their ranges exp, sin and cos still hold") {
  for (const double x : {700.5, 709.7, -710.0, -745.0, -2000.0}) {
    CAPTURE(x);
    CHECK(holds(mpfr_exp, x, exp_near(x)));
  }
  CHECK(std::isinf(exp_near(800).value));
  for (const double x : {0x1p20, 1e22, -1e300}) {
    CAPTURE(x);
    const auto [s, c] = sin_cos_near(x);
    CHECK(holds(mpfr_sin, x, s));
    CHECK(holds(mpfr_cos, x, c));
  }
}

TEST_CASE("log is within its error") {
  for (const double x : {0x1p-1074, 1e-300, 0.3, 1.0, 1 + 0x1p-52, 2.0, 1e300}) {
    CAPTURE(x);
    CHECK(holds(mpfr_log, x, log_near(x)));
  }
}

TEST_CASE("a wrong error is noticed") {
  const auto y = exp_near(0.3);
  CHECK_FALSE(holds(mpfr_exp, 0.3, {y.value * (1 + 0x1p-50), y.error}));
}
