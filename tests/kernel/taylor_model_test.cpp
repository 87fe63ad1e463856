// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor models hold the exact result: random functions, points of the triangle, all operations.
#include "kernel/arithmetic/taylor_model.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/arithmetic/taylor_combinations.hpp"
#include "tests/kernel/triangle_points.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

/// A model and the value at a point of one of the functions it encloses.
template <int N>
struct Sample {
  TaylorModel<N> model;
  Rational value;
};

template <int N>
std::string in_words(const Sample<N>& s) {
  return in_braces(s.model.c, s.model.radius, s.value);
}

template <int N>
Sample<N> draw_sample(Draw& d, const TrianglePoint& at, double constant, double size) {
  Sample<N> s;
  for (double& x : s.model.c)
    x = d.integer(0, 5) == 0 ? 0 : size * between(d, -1, 1) * std::exp2(d.integer(-20, 0));
  s.model.c[0] += constant;
  s.model.radius = d.integer(0, 2) == 0 ? 0 : size * std::exp2(d.integer(-50, -3));
  s.value = polynomial(s.model, at) + Rational(s.model.radius) * Rational(d.integer(-16, 16)) / 16;
  return s;
}

template <int N>
void check_ring_operations(Draw& d) {
  const TrianglePoint at = draw_triangle_point(d);
  const double size = std::exp2(d.integer(-60, 60));
  const auto a = draw_sample<N>(d, at, size * between(d, -2, 2), size);
  const auto b = draw_sample<N>(d, at, 0, std::exp2(d.integer(-60, 60)));
  const OnFailure shown(
      [&] { return "point " + in_words(at) + ", samples " + in_words(a) + ", " + in_words(b); });
  REQUIRE(encloses(a.model + b.model, at, a.value + b.value));
  REQUIRE(encloses(a.model - b.model, at, a.value - b.value));
  REQUIRE(encloses(a.model * b.model, at, a.value * b.value));
  REQUIRE(encloses(-a.model, at, -a.value));
  const double s = between(d, -3, 3);
  REQUIRE(encloses(s * a.model, at, Rational(s) * a.value));
  // Aliases.
  REQUIRE(encloses(a.model * a.model, at, a.value * a.value));
  REQUIRE(encloses(a.model - a.model, at, Rational(0)));
  TaylorModel<N> self = a.model;
  self = self * self + self;
  REQUIRE(encloses(self, at, a.value * a.value + a.value));
  REQUIRE(encloses(a.model / s, at, a.value / Rational(s)));
  // Flat factors; sums of products.
  const auto flat = TaylorModel<N>::around(s, d.coin() ? 0 : 0x1p-20);
  const Rational flat_value = Rational(s) + Rational(flat.radius) * Rational(d.integer(-4, 4)) / 4;
  REQUIRE(flat.is_flat());
  REQUIRE(encloses(flat * a.model, at, flat_value * a.value));
  REQUIRE(encloses(a.model * flat, at, a.value * flat_value));
  REQUIRE(encloses(flat * flat, at, flat_value * flat_value));
  REQUIRE((flat * flat).is_flat());
  TaylorModel<N> sum = b.model;
  add_product(sum, a.model, b.model);
  add_product(sum, flat, a.model);
  REQUIRE(encloses(sum, at, b.value + a.value * b.value + flat_value * a.value));
  add_product(sum, sum, a.model);
  REQUIRE(encloses(sum, at, (b.value + a.value * b.value + flat_value * a.value) * (1 + a.value)));
  REQUIRE(encloses(a.model.range(), a.value));
}

/// Weights at the ends of what is known of them, models of any sizes side by side.
template <int N>
void check_combinations(Draw& d) {
  const TrianglePoint at = draw_triangle_point(d);
  std::vector<Sample<N>> samples;
  const int count = d.integer(0, 10);
  for (int i = 0; i < count; ++i)
    samples.push_back(draw_sample<N>(d, at, between(d, -2, 2), std::exp2(d.integer(-30, 30))));
  TaylorCombinations<N, 10> combinations;
  for (const auto& s : samples) combinations.add(s.model);
  const double error = d.coin() ? 0 : std::exp2(d.integer(-60, -2));
  std::array<double, 10> weights{};
  Rational sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    weights[i] = d.integer(0, 4) == 0 ? 0 : between(d, -3, 3);
    sum += (Rational(weights[i]) + Rational(error) * d.integer(-1, 1)) * samples[i].value;
  }
  const auto r = combinations.of(weights, error);
  REQUIRE(encloses(r, at, sum));
  REQUIRE(std::isfinite(r.radius));
}

/// Nothing but rounding to absorb: linear functions, constants, no radius.
template <int N>
void check_rounding(Draw& d) {
  const TrianglePoint at = draw_triangle_point(d);
  const auto linear = [&] {
    TaylorModel<N> m;
    for (std::size_t k = 0; k < 3; ++k) m.c[k] = d.uniform();
    return m;
  };
  const auto a = linear(), b = linear();
  const OnFailure shown([&] { return "point, models = " + in_braces(at, a.c, b.c); });
  const Rational x = polynomial(a, at), y = polynomial(b, at);
  REQUIRE(encloses(a * b, at, x * y));
  REQUIRE(encloses(a + b, at, x + y));
  const double corners[3] = {d.uniform(), d.uniform(), d.uniform()};
  const Rational l1 = (2 * at.u + 1) / 3, l2 = (2 * at.v + 1) / 3;
  REQUIRE(encloses(TaylorModel<N>::linear(corners[0], corners[1], corners[2]), at,
                   (1 - l1 - l2) * Rational(corners[0]) + l1 * Rational(corners[1]) +
                       l2 * Rational(corners[2])));
}

template <int N>
void check_functions(Draw& d) {
  const TrianglePoint at = draw_triangle_point(d);
  const double share = std::exp2(d.integer(-12, -3));
  const double c = between(d, 0.2, 4) * (d.integer(0, 3) == 0 ? 100 : 1);
  // Without a size only the coefficients' own errors are left.
  const auto a = draw_sample<N>(d, at, c, d.integer(0, 3) == 0 ? 0 : c * share);
  const OnFailure shown([&] { return "point " + in_words(at) + ", sample " + in_words(a); });
  REQUIRE(encloses(inverse(a.model), at, 1 / a.value));
  REQUIRE(encloses(inverse(-a.model), at, -1 / a.value));
  struct Case {
    TaylorModel<N> model;
    MpfrFunction function;
  };
  for (const Case& f :
       {Case{sqrt(a.model), mpfr_sqrt}, Case{exp(a.model), mpfr_exp}, Case{log(a.model), mpfr_log},
        Case{sin(a.model), mpfr_sin}, Case{cos(a.model), mpfr_cos}}) {
    REQUIRE(f.model.radius > 0x1p-200);  // what 300 bits leave out is far below
    REQUIRE(encloses(f.model, at, precise(f.function, a.value)));
  }
}

/// Sizes from the least to the largest of doubles, so that sums, products, weights and the
/// denominators of remainders underflow and overflow.
template <int N>
void check_all_scales(Draw& d) {
  const TrianglePoint at = draw_triangle_point(d);
  const auto draw = [&] {
    const double size = std::exp2(d.integer(-1074, 1020));
    return draw_sample<N>(d, at, size * between(d, 1.5, 2), d.coin() ? size : size / 1024);
  };
  const auto a = draw(), b = draw();
  const OnFailure shown(
      [&] { return "point " + in_words(at) + ", samples " + in_words(a) + ", " + in_words(b); });
  REQUIRE(encloses(a.model + b.model, at, a.value + b.value));
  REQUIRE(encloses(a.model * b.model, at, a.value * b.value));
  TaylorModel<N> sum = b.model;
  add_product(sum, a.model, b.model);
  REQUIRE(encloses(sum, at, b.value + a.value * b.value));
  TaylorCombinations<N, 10> combinations;
  combinations.add(a.model);
  combinations.add(b.model);
  const double w = std::exp2(d.integer(-1074, 1020));
  REQUIRE(encloses(combinations.of({w, -1}, 0), at, Rational(w) * a.value - b.value));
  if (a.value <= 0) return;
  REQUIRE(encloses(inverse(a.model), at, 1 / a.value));
  REQUIRE(encloses(sqrt(a.model), at, precise(mpfr_sqrt, a.value)));
  REQUIRE(encloses(log(a.model), at, precise(mpfr_log, a.value)));
}

/// The remainder of sqrt at c where c^(N + 1), below it, overflows.
template <int N>
void check_remainders() {
  for (int exponent = 150; exponent < 1000; ++exponent) {
    const double c = std::exp2(exponent);
    const auto x = TaylorModel<N>::linear(c, 2 * c, c);
    for (const TrianglePoint& at :
         {point_of_weights(1, 0, 0), point_of_weights(0, 1, 0), point_of_weights(1, 2, 3)}) {
      INFO("2^" << exponent);
      REQUIRE(encloses(sqrt(x), at, precise(mpfr_sqrt, at.linear(c, 2 * c, c))));
    }
  }
}

template <int N>
void check_all() {
  Draw d(900 + N);
  for (std::uint64_t i = 0; i < scaled(4000); ++i) check_ring_operations<N>(d);
  for (std::uint64_t i = 0; i < scaled(2000); ++i) check_combinations<N>(d);
  for (std::uint64_t i = 0; i < scaled(4000); ++i) check_rounding<N>(d);
  for (std::uint64_t i = 0; i < scaled(1000); ++i) check_functions<N>(d);
  for (std::uint64_t i = 0; i < scaled(1000); ++i) check_all_scales<N>(d);
  check_remainders<N>();
}

}  // namespace

TEST_CASE("Taylor models of order 3 hold the exact results") {
  check_all<3>();
}
TEST_CASE("Taylor models of order 4 hold the exact results") {
  check_all<4>();
}
TEST_CASE("Taylor models of order 5 hold the exact results") {
  check_all<5>();
}

TEST_CASE("Taylor models: remainders are as small as the order promises") {
  // exp(x) with x linear, shrinking triangles: the remainder falls by 2^(n + 1) a halving.
  using Model = TaylorModel<4>;
  double last = 0;
  for (const double h : {0.25, 0.125, 0.0625}) {
    const double radius = exp(Model::linear(1, 1 + h, 1 - h)).radius;
    if (last > 0) CHECK(last / radius == Approx(32).epsilon(0.25));
    last = radius;
  }
  // The polynomial part is exact where the function is a polynomial of the order.
  const Model x = Model::linear(0, 1, 0), y = Model::linear(0, 0, 1);
  CHECK((x * x * y * y).radius < 1e-13);
}

TEST_CASE("Taylor models: Bernstein ranges are sharp at the corners") {
  using Model = TaylorModel<3>;
  const Model x = Model::linear(2, 5, 3);
  const Range r = x.range();
  CHECK(r.low == Approx(2).epsilon(1e-13));
  CHECK(r.high == Approx(5).epsilon(1e-13));
  // x (1 - x) on [0, 1] has range [0, 1/4]; the third-order Bernstein bound is 1/3.
  const Model t = Model::linear(0, 1, 0), p = t * (Model(1) - t);
  CHECK(p.range().high < 0.34);
  CHECK(p.range().low > -1e-13);
}

TEST_CASE("Taylor models: ranges on edges and at corners hold the values there") {
  Draw d(910);
  const auto check_order = [&](auto order) {
    constexpr int kOrder = decltype(order)::value;
    for (int i = 0; i < 3; ++i) {
      const TrianglePoint at = draw_edge_point(d, i);
      const auto s = draw_sample<kOrder>(d, at, d.uniform(), 1);
      const Range edge = s.model.range_on_edge(i), all = s.model.range();
      REQUIRE(encloses(edge, s.value));
      REQUIRE((all.low <= edge.low && edge.high <= all.high));
      const TrianglePoint corner = point_of_weights(i == 0, i == 1, i == 2);
      const auto t = draw_sample<kOrder>(d, corner, d.uniform(), 1);
      const Range there = t.model.at_corner(i), before = t.model.range_on_edge((i + 2) % 3);
      REQUIRE(encloses(there, t.value));
      REQUIRE(there.high - there.low <= 2 * t.model.radius + 1e-13);
      REQUIRE((before.low <= there.low && there.high <= before.high));
    }
  };
  for (std::uint64_t n = 0; n < scaled(500); ++n) {
    check_order(std::integral_constant<int, 3>{});
    check_order(std::integral_constant<int, 4>{});
    check_order(std::integral_constant<int, 5>{});
  }
}

TEST_CASE("Taylor models: what overflows or is not analytic is not certain") {
  using Model = TaylorModel<3>;
  const Model x = Model::linear(-1, 1, 0.5), huge = 1e300 * x;
  for (const Model& m : {huge * huge, inverse(x), sqrt(x), log(x), exp(huge), sin(huge * huge),
                         Model(std::numeric_limits<double>::quiet_NaN())}) {
    CHECK_FALSE(certain_sign(m.range()));
    CHECK_FALSE(certain_sign((m - m).range()));
    CHECK_FALSE(certain_sign((m * Model(0)).range()));
  }
  CHECK(certain_sign((x * x + Model(1.5)).range()) == Sign::positive);
  CHECK_FALSE(certain_sign((x - x).range()));
  CHECK(certain_sign(Model(0).range()) != Sign::negative);
}
