// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/spline_net.hpp"

#include <catch2/catch.hpp>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/polynomial/box_net.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

/// The derivative of the B-spline's pieces, from their formulas: c0 (1-t)^3 / 6 and so on.
Rational piece(int k, int order, const Rational& t) {
  const Rational a[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
  Rational r = 0;
  for (int power = 3; power >= order; --power) {
    Rational factor = 1;
    for (int i = 0; i < order; ++i) factor *= power - i;
    Rational x = 1;
    for (int i = 0; i < power - order; ++i) x *= t;
    r += factor * a[k][power] * x;
  }
  return r / 6;
}

}  // namespace

TEST_CASE("spline nets: values and derivatives to order 3 are exact, dimensions 2 and 3") {
  Draw d(1);
  for (int repeat = 0; repeat < 3; ++repeat)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        for (int c = 0; c < 4; ++c) {
          SplineCell<Rational, 3> net;
          SplineCell<Rational, 2> plane;
          for (auto& x : net) x = d.integer(-9, 9);
          for (auto& x : plane) x = d.integer(-9, 9);
          const auto cell = net;
          const auto square = plane;
          to_spline_net<Rational, 3>(net, {a, b, c});
          to_spline_net<Rational, 2>(plane, {a, b});
          const std::array<Rational, 3> t = {Rational(d.integer(0, 7)) / 7,
                                             Rational(d.integer(0, 5)) / 5,
                                             Rational(d.integer(0, 3)) / 3};
          Rational expected = 0, flat = 0;
          for (std::size_t i = 0; i < 64; ++i) {
            const int x = static_cast<int>(i % 4), y = static_cast<int>(i / 4 % 4),
                      z = static_cast<int>(i / 16);
            expected += cell[i] * piece(x, a, t[0]) * piece(y, b, t[1]) * piece(z, c, t[2]);
            if (z == 0) flat += square[i] * piece(x, a, t[0]) * piece(y, b, t[1]);
          }
          const std::array<std::array<Rational, 4>, 3> w = {
              spline_weights(t[0], a), spline_weights(t[1], b), spline_weights(t[2], c)};
          CHECK(spline_value<Rational, 3>(cell, w) == expected);
          CHECK(spline_value<Rational, 2>(square, {w[0], w[1]}) == flat);
          CHECK(value_at(BoxNet<Rational, 3, 3, 3>{net}, t) == expected);
          CHECK(value_at(BoxNet<Rational, 3, 3>{plane}, {t[0], t[1]}) == flat);
        }
}
