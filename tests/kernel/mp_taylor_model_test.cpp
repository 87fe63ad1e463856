// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor models over MPFR hold the exact result, and agree with those over doubles.
#include "kernel/arithmetic/mp_taylor_model.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/kernel/triangle_points.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

/// One function three times: enclosed by both kinds of model, and its value at the point.
template <int N>
struct MpSample {
  MpTaylorModel<N> mp;
  TaylorModel<N> model;
  Rational value;
};

template <int N>
MpSample<N> draw_mp_sample(Draw& d, const TrianglePoint& at, double constant, double size) {
  MpSample<N> s;
  for (std::size_t k = 0; k < s.model.c.size(); ++k) {
    s.model.c[k] = (d.integer(0, 4) == 0 ? 0 : size * d.uniform()) + (k == 0 ? constant : 0);
    s.mp.c[k] = MpInterval(s.model.c[k], s.mp.kBits);
  }
  s.model.radius = d.coin() ? 0 : size * std::exp2(d.integer(-50, -3));
  s.mp.remainder = MpInterval::between(-s.model.radius, s.model.radius, s.mp.kBits);
  s.value = polynomial(s.model, at) + Rational(s.model.radius) * Rational(d.integer(-16, 16)) / 16;
  return s;
}

bool meet(const Range& a, const Range& b) {
  return a.low <= b.high && b.low <= a.high;
}

/// Both enclose the value at the point, in the whole and in their ranges.
template <int N>
void check(const MpTaylorModel<N>& mp, const TaylorModel<N>& model, const TrianglePoint& at,
           const Rational& value) {
  REQUIRE(encloses(mp, at, value));
  REQUIRE(encloses(model, at, value));
  REQUIRE(encloses(mp.range(), value));
  REQUIRE(meet(mp.range(), model.range()));
  REQUIRE(meet(mp.range_on_edge(0), model.range_on_edge(0)));
  REQUIRE(meet(mp.at_corner(2), model.at_corner(2)));
}

template <int N>
void check_mp_operations(std::uint64_t cases) {
  Draw d(600 + N);
  for (std::uint64_t i = 0; i < cases; ++i) {
    const TrianglePoint at = draw_triangle_point(d);
    const double c = between(d, 0.5, 4);
    const auto a = draw_mp_sample<N>(d, at, c, c / 32), b = draw_mp_sample<N>(d, at, 0, 1);
    const double s = d.uniform();
    check(a.mp + b.mp, a.model + b.model, at, a.value + b.value);
    check(a.mp - b.mp, a.model - b.model, at, a.value - b.value);
    check(-a.mp, -a.model, at, -a.value);
    check(a.mp * b.mp, a.model * b.model, at, a.value * b.value);
    check(s * a.mp, s * a.model, at, Rational(s) * a.value);
    check(a.mp / s, a.model / s, at, a.value / Rational(s));
    check(b.mp / a.mp, b.model / a.model, at, b.value / a.value);
    check(sqrt(a.mp), sqrt(a.model), at, precise(mpfr_sqrt, a.value));
    check(exp(a.mp), exp(a.model), at, precise(mpfr_exp, a.value));
    check(log(a.mp), log(a.model), at, precise(mpfr_log, a.value));
    check(sin(a.mp), sin(a.model), at, precise(mpfr_sin, a.value));
    check(cos(a.mp), cos(a.model), at, precise(mpfr_cos, a.value));
  }
}

}  // namespace

TEST_CASE("MPFR Taylor models hold the exact results") {
  check_mp_operations<3>(scaled(60));
  check_mp_operations<4>(scaled(20));
  check_mp_operations<5>(scaled(10));
}

TEST_CASE("MPFR Taylor models bound the rest over all the values between") {
  // Far from the centre the next derivative is another: its value at the centre would not do.
  const auto check_corner = [](double at0, double at1, double at2) {
    const auto x = MpTaylorModel<3>::linear(at0, at1, at2);
    const TrianglePoint corner = point_of_weights(0, 1, 0);
    CHECK(encloses(exp(x), corner, precise(mpfr_exp, Rational(at1))));
    CHECK(encloses(sin(x), corner, precise(mpfr_sin, Rational(at1))));
    CHECK(encloses(cos(x), corner, precise(mpfr_cos, Rational(at1))));
    if (at0 <= 0 || at1 <= 0) return;
    CHECK(encloses(inverse(x), corner, 1 / Rational(at1)));
    CHECK(encloses(sqrt(x), corner, precise(mpfr_sqrt, Rational(at1))));
    CHECK(encloses(log(x), corner, precise(mpfr_log, Rational(at1))));
    CHECK(log(x).range().high < 10);
  };
  check_corner(-2, 4, -2);
  check_corner(1, -5, 1);
  check_corner(2.5, 1, 2.5);
  check_corner(2.875, 1.25, 2.875);
}

TEST_CASE("MPFR Taylor models: linear functions, exactness, what is undefined") {
  using Model = MpTaylorModel<3>;
  const Model x = Model::linear(0.25, -1, 2), y = Model::linear(0, 1, 0.5, 0x1p-20);
  const TrianglePoint at = point_of_weights(3, 4, 9);
  CHECK(encloses(x, at, at.linear(0.25, -1, 2)));
  CHECK(encloses(y, at, at.linear(0, 1, 0.5) + Rational(0x1p-20)));
  CHECK(x.at_corner(1).low == Approx(-1).epsilon(1e-14));
  CHECK(x.at_corner(2).high == Approx(2).epsilon(1e-14));
  CHECK(x.range_on_edge(2).low == Approx(0.25).epsilon(1e-14));
  CHECK((x * x * x).remainder.width() < 1e-28);
  CHECK(Model(2).is_flat());
  CHECK(Model::around(1, 0.5).range().high == 1.5);
  CHECK_FALSE(x.is_flat());
  for (const Model& m : {inverse(x), sqrt(x), log(x), sqrt(Model(-1)), Model(HUGE_VAL)}) {
    CHECK_FALSE(certain_sign(m.range()));
    CHECK_FALSE(certain_sign((m - m).range()));
  }
  // The Bernstein coefficients of x x on an edge from -1 to 2 are 1, -2, 4.
  CHECK(certain_sign((x * x + Model(2.5)).range()) == Sign::positive);
}
