// SPDX-License-Identifier: GPL-3.0-or-later
// Eight models at once: every lane has the bits of its model alone, undefined ones included.
#include "kernel/arithmetic/taylor_lanes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kernel/arithmetic/taylor_combinations.hpp"
#include "tests/support/degenerate_families.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

constexpr std::size_t kLanes = Lanes::count;

template <int N>
using Models = std::array<TaylorModel<N>, kLanes>;

/// The same bits; what is no number has none to speak of.
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}
template <int N>
bool same_bits(const TaylorModel<N>& a, const TaylorModel<N>& b) {
  for (std::size_t k = 0; k < a.c.size(); ++k)
    if (!same_bits(a.c[k], b.c[k])) return false;
  return same_bits(a.radius, b.radius);
}

template <int N>
TaylorModel<N> draw_model(Draw& d, Family family, bool flat) {
  TaylorModel<N> m;
  for (double& x : m.c)
    x = flat || d.integer(0, 5) == 0 ? (d.coin() ? 0.0 : -0.0) : draw(d, family);
  m.c[0] = draw(d, family) + d.integer(0, 40);
  m.radius = d.coin() ? 0 : std::fabs(draw(d, family)) * 0x1p-20;
  if (d.integer(0, 30) == 0)
    m.c[static_cast<std::size_t>(d.integer(0, 9))] = std::numeric_limits<double>::infinity();
  if (d.integer(0, 30) == 0) m.c[static_cast<std::size_t>(d.integer(0, 9))] = std::nan("");
  if (d.integer(0, 30) == 0) m.radius = std::numeric_limits<double>::infinity();
  return m;
}

/// Lanes that are all flat, or none, or some.
template <int N>
Models<N> draw_models(Draw& d, Family family) {
  Models<N> m;
  const int kind = d.integer(0, 2);
  for (auto& x : m) x = draw_model<N>(d, family, kind == 0 || (kind == 1 && d.coin()));
  return m;
}
template <int N>
TaylorLanes<N> together(const Models<N>& m) {
  TaylorLanes<N> t;
  for (std::size_t l = 0; l < kLanes; ++l) t.set_lane(l, m[l]);
  return t;
}

/// Counts lanes of f(a, b, s) that are not as alone; undefined operands must stay so.
template <int N, class F>
int differences(const Models<N>& a, const Models<N>& b, const Lanes& s, const F& f) {
  const TaylorLanes<N> r = f(together<N>(a), together<N>(b), s);
  int wrong = 0;
  for (std::size_t l = 0; l < kLanes; ++l) {
    wrong += same_bits(r.lane(l), f(a[l], b[l], s.x[l])) ? 0 : 1;
    wrong += !is_defined(a[l]) && is_defined(r.lane(l)) ? 1 : 0;
  }
  return wrong;
}

template <int N>
void check_lane_operations(Draw& d, Family family) {
  const Models<N> a = draw_models<N>(d, family), b = draw_models<N>(d, family);
  Lanes s;
  for (double& x : s.x)
    x = d.integer(0, 20) == 0 ? std::numeric_limits<double>::infinity() : draw(d, family);
  const auto wrong = [&](const auto& f) { return differences<N>(a, b, s, f); };
  CHECK(wrong([](const auto& x, const auto& y, const auto&) { return x + y; }) == 0);
  CHECK(wrong([](const auto& x, const auto& y, const auto&) { return x - y; }) == 0);
  CHECK(wrong([](const auto& x, const auto& y, const auto&) { return x * y; }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return x * x; }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return -x; }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto& t) { return x * t; }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto& t) { return x / t; }) == 0);
  CHECK(wrong([](const auto& x, const auto& y, const auto&) { return x / y; }) == 0);
  CHECK(wrong([](const auto& x, const auto& y, const auto&) {
          auto sum = y;
          add_product(sum, x, y);
          add_product(sum, sum, x);
          return sum;
        }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return inverse(x); }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return sqrt(x); }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return exp(x); }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return log(x); }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return sin(x); }) == 0);
  CHECK(wrong([](const auto& x, const auto&, const auto&) { return cos(x); }) == 0);
  const TaylorLanes<N> all = together<N>(a);
  const LaneRanges ranges = all.range();
  bool every = true;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const Range alone = a[l].range();
    CHECK((same_bits(ranges[l].low, alone.low) && same_bits(ranges[l].high, alone.high)));
    every = every && is_defined(a[l]);
  }
  CHECK(is_defined(all) == every);
}

template <int N>
void check_lane_combinations(Draw& d, Family family) {
  constexpr std::size_t kTerms = 5;
  std::array<Models<N>, kTerms> models;
  std::array<TaylorLanes<N>, kTerms> lanes;
  std::array<Lanes, kTerms> weights;
  TaylorLaneCombinations<N, kTerms> sums;
  for (std::size_t i = 0; i < kTerms; ++i) {
    models[i] = draw_models<N>(d, family);
    lanes[i] = together<N>(models[i]);
    for (double& w : weights[i].x) w = draw(d, family);
    sums.add(lanes[i]);
  }
  const TaylorLanes<N> r = sums.of(weights, 0x1p-40);
  for (std::size_t l = 0; l < kLanes; ++l) {
    TaylorCombinations<N, kTerms> alone;
    std::array<double, kTerms> w{};
    for (std::size_t i = 0; i < kTerms; ++i) alone.add(models[i][l]), w[i] = weights[i].x[l];
    CHECK(same_bits(r.lane(l), alone.of(w, 0x1p-40)));
  }
}

TEST_CASE("Taylor models side by side have the bits of each alone, flat and undefined ones too") {
  for (const Family family : kFamilies) {
    Draw d(8, family);
    for (int i = 0; i < 40; ++i) {
      check_lane_operations<3>(d, family);
      check_lane_operations<4>(d, family);
      check_lane_operations<5>(d, family);
      check_lane_combinations<3>(d, family);
      check_lane_combinations<4>(d, family);
    }
  }
}

TEST_CASE("A jet of models side by side is undefined in every lane if its value is in one") {
  using Jet = Jet<TaylorLanes<4>, 2, 2>;
  for (std::size_t bad = 0; bad < kLanes; ++bad) {
    Lanes at;
    for (std::size_t l = 0; l < kLanes; ++l) at.x[l] = l == bad ? -1 : 1;
    const Jet x = Jet::variable(0, TaylorLanes<4>(at)), y = Jet::variable(1, TaylorLanes<4>(2.0));
    for (const Jet& f : {log(x), sqrt(x), log(x) * y, y / sqrt(x), log(x) - log(x),
                         exp(log(x)) * 0.0, y + log(x), inverse(sqrt(x))}) {
      CHECK_FALSE(is_defined(f));
      for (std::size_t k = 0; k < Jet::kCount; ++k)
        for (std::size_t l = 0; l < kLanes; ++l) CHECK_FALSE(is_defined(f[k].lane(l)));
    }
    CHECK(is_defined(x * y));
  }
}

}  // namespace
