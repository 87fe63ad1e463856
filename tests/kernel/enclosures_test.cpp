// SPDX-License-Identifier: GPL-3.0-or-later
// Constants and expressions over enclosing types; elementary functions of intervals.
#include "kernel/expressions/enclosures.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/kernel/triangle_points.hpp"
#include "tests/kernel/xyz.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

Constant constant(const std::string& text) {
  return Expression::parse(text, {}).constants().at(0);
}

/// To 300 bits.
Rational precise_constant(const Constant& c) {
  if (c.kind == Constant::Kind::number) return c.exact;
  if (c.kind == Constant::Kind::e) return precise(mpfr_exp, 1);
  return 4 * precise(mpfr_atan, 1);
}

struct Function {
  const char* name;
  Interval (*interval)(const Interval&);
  MpInterval (*mp)(const MpInterval&);
  MpfrFunction precise;
  double lowest;  // of the arguments drawn
};
const Function kFunctions[] = {{"exp", [](const Interval& x) { return exp(x); },
                                [](const MpInterval& x) { return exp(x); }, mpfr_exp, -40},
                               {"log", [](const Interval& x) { return log(x); },
                                [](const MpInterval& x) { return log(x); }, mpfr_log, 1e-9},
                               {"sin", [](const Interval& x) { return sin(x); },
                                [](const MpInterval& x) { return sin(x); }, mpfr_sin, -40},
                               {"cos", [](const Interval& x) { return cos(x); },
                                [](const MpInterval& x) { return cos(x); }, mpfr_cos, -40}};

bool same(const Interval& a, const Interval& b) {
  return a.inf() == b.inf() && a.sup() == b.sup();
}
bool whole(const Interval& x) {
  return std::isinf(x.inf()) && std::isinf(x.sup()) && x.inf() < x.sup();
}

void check_function(const Function& f, Draw& d) {
  const double a = between(d, f.lowest, 40), b = a + std::exp2(d.integer(-60, 4)) * (a > 0 ? a : 1);
  const Interval x(a, b), result = f.interval(x);
  const MpInterval mp_result = f.mp(MpInterval::between(a, b, 106));
  for (int n = 0; n <= 6; ++n) {
    const Rational at = Rational(a) + (Rational(b) - Rational(a)) * n / 6;
    const Rational value = precise(f.precise, at);
    CAPTURE(f.name, a, b, n);
    REQUIRE(encloses(Range{result.inf(), result.sup()}, value));
    // What 300 bits leave out is 2^-170 of what 106 do, and values are no 106-bit numbers.
    REQUIRE(mp_result.contains(value));
  }
  const Interval point = f.interval(Interval(a));
  REQUIRE(point.sup() <= std::nextafter(point.inf(), HUGE_VAL));
  RoundUpward guard;
  REQUIRE(same(result, f.interval(x)));
  REQUIRE(same(point, f.interval(Interval(a))));
}

}  // namespace

TEST_CASE("Elementary functions of intervals hold those of their points") {
  Draw d(81);
  for (std::uint64_t i = 0; i < scaled(400); ++i)
    for (const Function& f : kFunctions) check_function(f, d);
}

TEST_CASE("Elementary functions of intervals: extremes, poles, what is undefined") {
  CHECK(sin(Interval(1, 2)).sup() == 1);
  CHECK(sin(Interval(1, 2)).inf() < 0.8415);
  CHECK(sin(Interval(4, 5)).inf() == -1);
  CHECK(cos(Interval(-1, 1)).sup() == 1);
  CHECK(cos(Interval(3, 4)).inf() == -1);
  CHECK(cos(Interval(0.5, 3)).sup() < 0.88);
  CHECK(same(cos(Interval(3, 7)), Interval(-1, 1)));
  CHECK(same(sin(Interval(-1e300, 1e300)), Interval(-1, 1)));
  CHECK(same(exp(Interval(0)), Interval(1)));
  CHECK(same(log(Interval(1)), Interval(0)));
  CHECK(whole(exp(Interval(0, 1000))));
  CHECK(exp(Interval(-1000, 0)).inf() == 0);
  CHECK(whole(log(Interval(0, 1))));
  CHECK(whole(log(Interval(-1, 1))));
  CHECK(whole(log(Interval(-2, -1))));
  RoundUpward guard;
  CHECK(whole(sqrt(Interval(-1, 4))));
  CHECK(whole(sqrt(Interval(-4, -1))));
  CHECK(same(sqrt(Interval(4, 9)), Interval(2, 3)));
}

TEST_CASE("MPFR intervals with doubles") {
  Draw d(82);
  for (std::uint64_t i = 0; i < scaled(500); ++i) {
    const double low = d.uniform(), high = low + d.integer(0, 2) * 0.75, s = d.uniform();
    const MpInterval x = MpInterval::between(low, high, 60);
    const Rational at = (Rational(low) + Rational(high)) / 2, t(s);
    const OnFailure shown([&] { return "low, high, s = " + in_braces(low, high, s); });
    REQUIRE((x + s).contains(at + t));
    REQUIRE((x - s).contains(at - t));
    REQUIRE((x * s).contains(at * t));
    REQUIRE((x / s).contains(at / t));
    REQUIRE(x.contains(at));
    REQUIRE((x * s).width() <= std::fabs(s) * (high - low) + 1e-15);
  }
  CHECK(std::isinf((MpInterval(1.0, 60) / 0.0).upper()));
  CHECK(std::isinf(MpInterval::between(2, 1, 60).lower()));
}

TEST_CASE("Constants are enclosed, doubles without an error") {
  for (const char* text : {"0.1", "3", "1e400", "1e-400", "123456789012345678901234567890", "pi",
                           "e", "0.1000000000000000055511151231257827021181583404541015625"}) {
    const Constant c = constant(text);
    const Rational exact = precise_constant(c);
    CAPTURE(text);
    const Interval x = as_interval(c);
    CHECK(encloses(Range{x.inf(), x.sup()}, exact));
    CHECK(as_mp_interval(c, 106).contains(exact));
    CHECK(as_mp_interval(c, 106).width() <= 0x1p-100 * std::fabs(x.sup()) + 0x1p-1074);
    const TrianglePoint at = point_of_weights(1, 2, 3);
    CHECK(encloses(as_taylor<3>(c), at, exact));
    CHECK(as_taylor<3>(c).is_flat());
    CHECK(encloses(as_enclosure(c, static_cast<const MpTaylorModel<3>*>(nullptr)), at, exact));
    if (std::isfinite(c.nearest)) {
      CHECK(as_taylor<3>(c).radius <= std::fabs(c.nearest) * 0x1.1p-53 + 0x1p-1074);
      CHECK(x.sup() <= std::nextafter(x.inf(), HUGE_VAL));
      CHECK((as_taylor<3>(c).radius == 0) == (exact == Rational(c.nearest)));
    }
  }
}

TEST_CASE("Expressions with their derivatives are enclosed by Taylor models") {
  // Against intervals of 200 bits at points of the triangle.
  for (const char* text :
       {"exp(x*y)*sin(z)/sqrt(2+x) + log(3+y)*cos(x)^2 - pi*z + e", "x^2 + y^2/2.25 + z^2/4 - 1",
        "(x^2+y^2+z^2+0.3)^2 - 4*(x^2+y^2) + 0.1*sin(5*x)",
        "1/(1+x^2)^3 - sqrt(4-z)*exp(-y^2) + x^-2"}) {
    const auto expression = Expression::parse(text, kXyz);
    auto model = taylor_jet_evaluator<4, 3, 4>(expression);
    auto precise = mp_jet_evaluator<3, 4>(expression, 200);
    Draw d(83);
    for (std::uint64_t i = 0; i < scaled(10); ++i) {
      const TrianglePoint at = draw_triangle_point(d);
      std::vector<Jet<TaylorModel<4>, 3, 4>> x;
      std::vector<Jet<MpInterval, 3, 4>> point;
      for (int v = 0; v < 3; ++v) {
        const double c = between(d, 0.5, 1), c1 = c + d.uniform() / 64, c2 = c + d.uniform() / 64;
        x.push_back(Jet<TaylorModel<4>, 3, 4>::variable(v, TaylorModel<4>::linear(c, c1, c2)));
        point.push_back(
            Jet<MpInterval, 3, 4>::variable(v, MpInterval::from(at.linear(c, c1, c2), 200)));
      }
      const auto result = model(x);
      const auto truth = precise(point);
      for (std::size_t k = 0; k < result.kCount; ++k) {
        CAPTURE(text, i, k);
        REQUIRE(std::isfinite(result[k].radius));
        // Some point of the tiny interval within the radius.
        const MpInterval off = truth[k] - MpInterval::from(polynomial(result[k], at), 300);
        REQUIRE(off.lower() <= result[k].radius);
        REQUIRE(off.upper() >= -result[k].radius);
        REQUIRE(result[k].radius <= 1e-2 * (1 + std::fabs(truth[k].upper())));
      }
    }
  }
}

TEST_CASE("Expressions that are undefined have no enclosed value") {
  const auto root = Expression::parse("sqrt(-1)", kXyz);
  const std::vector<Jet<MpInterval, 1, 2>> none;
  CHECK(std::isinf((mp_jet_evaluator<1, 2>(root, 106)(none)[0].upper())));
  CHECK_FALSE(certain_sign((taylor_jet_evaluator<3, 1, 2>(root)({})[0].range())));
  CHECK_FALSE(certain_sign((jet_evaluator<MpTaylorModel<3>, 1, 2>(root)({})[0].range())));
  RoundUpward guard;
  CHECK(whole(jet_evaluator<Interval, 1, 2>(root)({})[0]));
  CHECK(whole(Evaluator<Interval>(root, as_interval, Interval(1))({})));
}
