// SPDX-License-Identifier: GPL-3.0-or-later
// Jets: exact over rationals, enclosing over everything else, zero where their mask says so.
#include "kernel/arithmetic/jet.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernel/expressions/enclosures.hpp"
#include "tests/kernel/triangle_points.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;

template <int V, int O>
using ExactJet = Jet<Rational, V, O>;

Rational draw_rational(Draw& d) {
  return Rational(d.integer(-30, 30), d.integer(1, 9));
}

template <class J>
J power(const J& x, int n, J one) {
  for (; n > 0; --n) one = one * x;
  return one;
}

/// A product by its definition, without masks, tables or the case of a square.
template <class T, int V, int O>
std::vector<T> dense_product(const Jet<T, V, O>& a, const Jet<T, V, O>& b) {
  const auto& e = a.kTables.kMonomials.exponents;
  std::vector<T> r(e.size(), T(0.0));
  for (std::size_t i = 0; i < e.size(); ++i)
    for (std::size_t j = 0; j < e.size(); ++j) {
      auto sum = e[i];
      for (std::size_t v = 0; v < V; ++v) sum[v] = static_cast<std::uint8_t>(sum[v] + e[j][v]);
      for (std::size_t k = 0; k < e.size(); ++k)
        if (e[k] == sum) r[k] = r[k] + a[i] * b[j];
    }
  return r;
}

template <int V, int O>
ExactJet<V, O> draw_jet(Draw& d) {
  ExactJet<V, O> sum;
  for (int n = d.integer(1, 4); n > 0; --n) {
    auto term = ExactJet<V, O>::constant(draw_rational(d));
    for (int i = 0; i < V; ++i)
      if (d.coin())
        term = term * power(ExactJet<V, O>::variable(i, d.coin() ? Rational(0) : draw_rational(d)),
                            d.integer(0, 3), ExactJet<V, O>::constant(1));
    sum = d.coin() ? sum + term : sum - term;
  }
  return sum;
}

template <int V, int O>
void check_against_definition(Draw& d) {
  // A monomial's derivatives are binomials times powers.
  Rational x[V], expected[monomial_count(V, O)];
  int m[V];
  auto f = ExactJet<V, O>::constant(1);
  for (int v = 0; v < V; ++v) {
    x[v] = draw_rational(d);
    m[v] = d.integer(0, 6);
    for (int i = 0; i < m[v]; ++i) f = f * ExactJet<V, O>::variable(v, x[v]);
  }
  for (std::size_t k = 0; k < f.kCount; ++k) {
    Rational c = 1;
    for (std::size_t v = 0; v < V; ++v) {
      const int a = f.kTables.kMonomials.exponents[k][v];
      for (int i = 0; i < a; ++i) c *= Rational(m[v] - i, i + 1);
      for (int i = a; i < m[v]; ++i) c *= x[v];
    }
    REQUIRE(f[k] == c);
  }
  const auto a = draw_jet<V, O>(d), b = draw_jet<V, O>(d);
  const auto same = [](const ExactJet<V, O>& p, const std::vector<Rational>& q) {
    for (std::size_t k = 0; k < q.size(); ++k)
      if (p[k] != q[k] || (q[k] != 0 && !(p.mask() >> k & 1))) return false;
    return true;
  };
  REQUIRE(same(a * b, dense_product(a, b)));
  REQUIRE(same(a * a, dense_product(a, a)));
  const auto values = [](const ExactJet<V, O>& p) {
    std::vector<Rational> r;
    for (std::size_t k = 0; k < p.kCount; ++k) r.push_back(p[k]);
    return r;
  };
  REQUIRE(same((a + b) - b, values(a)));
  REQUIRE(same(-(b - a), values(a - b)));
  REQUIRE(same((a * 1.5 - 0.25) * 4.0, values(6.0 * a + -1.0)));
  if (b[0] != 0) {
    const auto q = a / b;
    REQUIRE(same(a, dense_product(q, b)));
    REQUIRE(same(1.0 / b, values(inverse(b))));
    REQUIRE(same(a / 3.0, values(a / ExactJet<V, O>::constant(3))));
  }
}

template <int V, int O>
void check_orders_down() {
  Draw d(7000 + 10 * V + O);
  for (std::uint64_t i = 0; i < scaled(30); ++i) check_against_definition<V, O>(d);
  if constexpr (O > 0) check_orders_down<V, O - 1>();
}

/// The same random formula over every number type; only points where it is analytic.
template <class J>
J formula(Draw& d, int depth, const std::vector<J>& x) {
  if (depth == 0) return x[static_cast<std::size_t>(d.integer(0, 2))];
  const J a = formula(d, depth - 1, x), b = formula(d, depth - 1, x);
  switch (d.integer(0, 5)) {
    case 0:
      return a + 0.75 * b;
    case 1:
      return 2.0 - a * b;
    case 2:
      return (a - b) * (a - b);
    case 3:
      return a / (b * b + 3.0);
    case 4:
      return (a + 1.0) * (b / 4.0);
    default:
      return b - a;
  }
}

template <class T, int Order, class Convert>
void check_encloses(std::uint64_t salt, std::uint64_t cases, Convert&& variable) {
  for (std::uint64_t i = 0; i < cases; ++i) {
    Draw d(salt * 100000 + i);
    const TrianglePoint at = draw_triangle_point(d);
    std::vector<Jet<T, 3, Order>> x;
    std::vector<ExactJet<3, Order>> exact;
    const double size = std::exp2(d.integer(-12, -3));
    for (int v = 0; v < 3; ++v) {
      const double c = between(d, -1, 1);
      const double corner[3] = {c, c + size * d.uniform(), c + size * d.uniform()};
      exact.push_back(ExactJet<3, Order>::variable(v, at.linear(corner[0], corner[1], corner[2])));
      x.push_back(Jet<T, 3, Order>::variable(v, variable(corner, exact.back()[0])));
    }
    Draw again = d;
    const auto value = formula(d, 3, x);
    const auto truth = formula(again, 3, exact);
    for (std::size_t k = 0; k < value.kCount; ++k) {
      CAPTURE(i, k);
      REQUIRE(encloses(value[k], at, truth[k]));
      REQUIRE((truth[k] == 0 || (value.mask() >> k & 1)));
    }
  }
}

template <class T>
T linear_model(const double* corner, const Rational&) {
  return T::linear(corner[0], corner[1], corner[2]);
}

}  // namespace

TEST_CASE("Jets over rationals are exact") {
  check_orders_down<1, 5>();
  check_orders_down<2, 5>();
  check_orders_down<3, 5>();
}

TEST_CASE("Jets over Taylor models hold the exact derivatives") {
  check_encloses<TaylorModel<3>, 4>(31, scaled(60), linear_model<TaylorModel<3>>);
  check_encloses<TaylorModel<4>, 3>(32, scaled(60), linear_model<TaylorModel<4>>);
  check_encloses<TaylorModel<5>, 2>(33, scaled(60), linear_model<TaylorModel<5>>);
  check_encloses<MpTaylorModel<3>, 2>(34, scaled(5), linear_model<MpTaylorModel<3>>);
}

TEST_CASE("Jets over intervals hold the exact derivatives") {
  const auto mp = [](const double*, const Rational& x) { return MpInterval::from(x, 80); };
  check_encloses<MpInterval, 4>(35, scaled(30), mp);
  RoundUpward guard;
  const auto enclosure = [&](const double*, const Rational& x) {
    const MpInterval e = MpInterval::from(x, 53);
    return Interval(e.lower(), e.upper());
  };
  check_encloses<Interval, 4>(36, scaled(60), enclosure);
}

TEST_CASE("Jets: functions agree with their series composed") {
  // f(h) = sum t_k (h - h_0)^k, t_k from MPFR, over intervals of 200 bits.
  constexpr int kOrder = 5;
  using J = Jet<MpInterval, 2, kOrder>;
  const auto number = [](double x) { return MpInterval(x, 200); };
  Draw d(71);
  for (std::uint64_t n = 0; n < scaled(20); ++n) {
    const J x = J::variable(0, number(between(d, 0.2, 2))), y = J::variable(1, number(d.uniform()));
    const J h = x * x + 0.25 * (x * y) * y + (d.coin() ? J::constant(number(1)) : y * y * y * y);
    const MpInterval& c = h[0];
    const J rest = h - J::constant(c);
    const auto composed = [&](auto&& t) {
      J r = J::constant(t(kOrder));
      for (int k = kOrder - 1; k >= 0; --k) r = r * rest + J::constant(t(k));
      return r;
    };
    const auto over_factorial = [](MpInterval t, int k) {
      for (; k > 1; --k) t = t / k;
      return t;
    };
    const MpInterval wave[4] = {sin(c), cos(c), -sin(c), -cos(c)};
    const auto binomial = [&](int k) {
      MpInterval t = sqrt(c);
      for (int i = 0; i < k; ++i) t = t * (0.5 - i) / (c * (i + 1.0));
      return t;
    };
    const auto log_term = [&](int k) {
      if (k == 0) return log(c);
      MpInterval t = number(k % 2 ? 1 : -1) / k;
      for (int i = 0; i < k; ++i) t = t / c;
      return t;
    };
    const std::pair<J, J> pairs[] = {
        {exp(h), composed([&](int k) { return over_factorial(exp(c), k); })},
        {sin(h), composed([&](int k) { return over_factorial(wave[k % 4], k); })},
        {cos(h), composed([&](int k) { return over_factorial(wave[(k + 1) % 4], k); })},
        {sqrt(h), composed(binomial)},
        {log(h), composed(log_term)}};
    for (const auto& [direct, series] : pairs)
      for (std::size_t k = 0; k < J::kCount; ++k) {
        REQUIRE((direct[k] - series[k]).contains_zero());
        REQUIRE(direct[k].width() < 1e-40);
      }
  }
}

TEST_CASE("Jets keep what is identically zero out of all products") {
  using J = Jet<double, 3, 4>;
  const J x = J::variable(0, 0.5), y = J::variable(1, 0.25), z = J::variable(2, -2);
  const J quadric = x * x + y * y / 2.0 + z * z - 1.0;
  int held = 0;
  for_each_bit(quadric.mask(), [&](std::size_t k) {
    CHECK(J::kTables.degree[k] <= 2);
    ++held;
  });
  CHECK(held == 7);  // the value, three first and three pure second derivatives
  CHECK(quadric.derivative(0, 2, 0) == 1);
  CHECK(quadric.derivative(1, 1, 0) == 0);
  CHECK(quadric.derivative(0, 0, 1) == -4);
  CHECK(J().mask() == 0);
  CHECK(exp(J::constant(1.0)).mask() == 1);
  CHECK(log(x + 1.0).mask() == sqrt(x + 1.0).mask());
  CHECK(std::popcount(sin(x).mask()) == 5);
  CHECK(std::popcount((x / (y + 1.0)).mask()) == 5 + 4);  // y^k, x y^k
  // A point that moves and copies keeps its coefficients.
  J copy = quadric, moved = std::move(copy);
  copy = x;
  copy = moved;
  CHECK(copy.mask() == quadric.mask());
  CHECK(copy[0] == quadric[0]);
}
