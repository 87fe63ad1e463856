// SPDX-License-Identifier: GPL-3.0-or-later
// Models and jets of the second checker against values and derivatives that are known.
#include "certify/second/model.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "certify/second/expression.hpp"
#include "certify/second/jet.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest::recheck;

constexpr const char* kTexts[] = {"x*y+z^3",         "exp(x*y)-sin(z)*cos(x)",
                                  "log(3+x+y*z)",    "sqrt(4+x*y)-1/(3+z)",
                                  "(x-y)^7/(5+x^2)", "cos(3*x)*exp(-z^2)"};

}  // namespace

TEST_CASE("recheck: the range of a model holds every value on the triangle, and not much more") {
  crest::tests::Random random(41);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const int order : {3, 4, 5})
    for (const char* text : kTexts)
      for (int repeat = 0; repeat < 20; ++repeat) {
        const Scope scope;
        context.order = order;
        const Expression f = Expression::parse(text, {"x", "y", "z"});
        const double size = std::ldexp(1.0, -(repeat % 5));
        std::array<std::array<double, 3>, 3> corner;  // [coordinate][corner]
        std::vector<Model> at;
        for (auto& x : corner) {
          const double centre = coordinate(random);
          for (double& value : x) value = centre + size * coordinate(random) / 2;
          at.push_back(Model::linear(Ball(x[0]), Ball(x[1]) - Ball(x[0]), Ball(x[2]) - Ball(x[0])));
        }
        const Interval range = f.evaluate(at).range();
        double least = INFINITY, greatest = -INFINITY;
        constexpr int n = 12;
        for (int i = 0; i <= n; ++i)
          for (int j = 0; i + j <= n; ++j) {
            std::vector<Ball> point;
            for (const auto& x : corner)
              point.push_back(scaled(Ball(x[0]), n - i - j, n) + scaled(Ball(x[1]), i, n) +
                              scaled(Ball(x[2]), j, n));
            const Interval value(f.evaluate(point));
            CHECK(range.lower() <= value.upper());
            CHECK(value.lower() <= range.upper());
            least = std::min(least, value.lower());
            greatest = std::max(greatest, value.upper());
          }
        INFO(text << ", order " << order << ", size " << size);
        const double excess = range.upper() - range.lower() - (greatest - least);
        CHECK(excess <= 20 * std::pow(size, 2));
      }
}

TEST_CASE("recheck: jets have the derivatives of their functions") {
  const Scope scope(3);
  const Expression f = Expression::parse("sin(x)*y^2+exp(z)/(1+x)", {"x", "y", "z"});
  std::vector<Jet<Model, 3>> at;
  const std::array<double, 3> point = {0.25, -1.5, 0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Model, 3> slopes;
    slopes[k] = Model(1.0);
    at.emplace_back(Model(point[k]), slopes);
  }
  const Jet<Model, 3> jet = f.evaluate(at);
  const auto coefficient = [&](std::array<int, 3> e) {
    return jet[Monomials<3>::get().find(e)].range().middle();
  };
  const double x = point[0], y = point[1], ez = std::exp(point[2]);
  const auto near = [](double v) { return Approx(v).epsilon(1e-13); };
  CHECK(coefficient({0, 0, 0}) == near(std::sin(x) * y * y + ez / (1 + x)));
  CHECK(coefficient({1, 0, 0}) == near(std::cos(x) * y * y - ez / ((1 + x) * (1 + x))));
  CHECK(coefficient({1, 1, 0}) == near(std::cos(x) * 2 * y));
  CHECK(coefficient({1, 2, 0}) == near(std::cos(x)));
  CHECK(coefficient({0, 0, 3}) == near(ez / (1 + x) / 6));
  CHECK(coefficient({2, 0, 1}) == near(ez / std::pow(1 + x, 3)));
}

TEST_CASE("recheck: even powers of intervals are not negative") {
  const Interval around(-2, 1);
  CHECK(power(around, 2).lower() == 0);
  CHECK(power(around, 2).upper() == 4);
  CHECK(power(around, 3).lower() == -8);
  CHECK(sqrt(power(around, 4)).lower() == 0);
  CHECK_THROWS_AS(inverse(around), Undefined);
  CHECK_THROWS_AS(log(Interval(0, 1)), Undefined);
}

TEST_CASE("recheck: sums and products of models of far exponents hold zero where they must") {
  crest::tests::Random random(43);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto model = [&] {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 400) - 200);
    const auto value = [&] { return Ball(random() % 5 == 0 ? 0 : size * coordinate(random)); };
    return random() % 4 == 0 ? Model(value()) : Model::linear(value(), value(), value());
  };
  const auto size = [](const Model& m) {
    const Interval r = m.range();
    return std::max(-r.lower(), r.upper());
  };
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const Model a = model(), b = model(), c = model();
    const Model square = (a + b) * (a + b) - a * a - scaled(a * b, 2) - b * b;
    const Model distributed = (a + b) * c - c * a - c * b;
    const Model thirds = scaled(a, 1, 3) + scaled(a, 2, 3) - a;
    const double most = std::max({size(a), size(b), size(c)});
    for (const auto& [zero, scale] : {std::pair{(a + b) - a - b, most},
                                      {a + a - scaled(a, 2), size(a)},
                                      {square, most * most},
                                      {distributed, most * most},
                                      {thirds, size(a)}}) {
      const Interval r = zero.range();
      CHECK(r.lower() <= 0);
      CHECK(r.upper() >= 0);
      CHECK(r.upper() - r.lower() <= 0x1p-45 * scale);
    }
  }
  Model a = Model::linear(Ball(1.0), Ball(0.5), Ball(0.25));
  a += a;
  CHECK((a - Model::linear(Ball(2.0), Ball(1.0), Ball(0.5))).range().upper() <= 0x1p-50);
  a.add_product(a, a);
  CHECK((a - Model::linear(Ball(2.0), Ball(1.0), Ball(0.5)) *
                 Model::linear(Ball(3.0), Ball(1.0), Ball(0.5)))
            .range()
            .upper() <= 0x1p-48);
}
