// SPDX-License-Identifier: GPL-3.0-or-later
// Bezier nets and forms on simplices and boxes: each law of the headers, in rationals.
#include <catch2/catch.hpp>

#include "kernel/polynomial/box_net.hpp"
#include "kernel/polynomial/box_parts.hpp"
#include "kernel/polynomial/lattice_values.hpp"
#include "kernel/polynomial/simplex_net.hpp"
#include "kernel/polynomial/simplex_parts.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

Rational small(Draw& d) {
  return Rational(d.integer(-20, 20), d.integer(1, 7));
}
template <class N>
N draw_net(Draw& d) {
  N r;
  for (auto& x : r.c) x = small(d);
  return r;
}
template <std::size_t Corners>
std::array<Rational, Corners> barycentric(Draw& d) {
  std::array<Rational, Corners> l;
  l[0] = 1;
  for (std::size_t k = 1; k < Corners; ++k) l[0] -= l[k] = small(d);
  return l;
}

/// The sum of coefficients times weights times powers: the definition.
template <int Dim, int Degree>
Rational by_definition(const SimplexNet<Rational, Dim, Degree>& b,
                       const std::array<Rational, Dim + 1>& l) {
  using B = SimplexBasis<Dim, Degree>;
  Rational sum = 0;
  for (std::size_t i = 0; i < B::count; ++i) {
    Rational term = b.c[i] * Rational(B::weights[i]);
    for (std::size_t k = 0; k <= Dim; ++k)
      for (int power = 0; power < B::indices[i][k]; ++power) term *= l[k];
    sum += term;
  }
  return sum;
}
template <int... N, std::size_t Dim>
Rational by_definition(const BoxNet<Rational, N...>& b, const std::array<Rational, Dim>& x) {
  using B = BoxBasis<N...>;
  Rational sum = 0;
  for (std::size_t i = 0; i < B::count; ++i) {
    Rational term = b.c[i] * Rational(B::weights[i]);
    for (std::size_t k = 0; k < Dim; ++k)
      for (std::size_t power = 0; power < B::degrees[k]; ++power)
        term *= power < B::indices[i][k] ? x[k] : Rational(1 - x[k]);
    sum += term;
  }
  return sum;
}

template <class B>
void require_basis() {
  for (std::size_t i = 0; i < B::count; ++i) REQUIRE(B::position(B::indices[i]) == i);
}

template <int Dim, int Degree>
void require_simplex_laws(Draw& d) {
  using B = SimplexBasis<Dim, Degree>;
  require_basis<B>();
  const auto b = draw_net<SimplexNet<Rational, Dim, Degree>>(d);
  const auto l = barycentric<Dim + 1>(d);
  const Rational value = by_definition(b, l);
  REQUIRE(value_at(b, l) == value);
  REQUIRE(value_at(raised(b), l) == value);
  REQUIRE(value_at(net(form(b)), l) == value);
  REQUIRE(value_at(net(raised<SimplexBasis<Dim, 2>>(form(b))), l) == value);
  const auto other = draw_net<SimplexNet<Rational, Dim, 2>>(d);
  REQUIRE(value_at(b * other, l) == value * value_at(other, l));
  // Gradient: Euler's identity, and the derivative along a direction.
  const auto g = value_and_gradient_at(b, l);
  REQUIRE(g.value == value);
  Rational euler = 0, along = 0;
  std::array<Rational, Dim + 1> w = barycentric<Dim + 1>(d);
  w[0] -= 1;
  for (std::size_t k = 0; k <= Dim; ++k) {
    euler += l[k] * g.gradient[k];
    along += w[k] * g.gradient[k];
  }
  REQUIRE(euler == Degree * value);
  REQUIRE(value_at(derivative(b, w), l) == along);
  // The derivative is one: exact difference quotients of degree 1 nets.
  if constexpr (Degree == 1) {
    auto moved = l;
    for (std::size_t k = 0; k <= Dim; ++k) moved[k] += w[k];
    REQUIRE(value_at(b, moved) - value == along);
  }
  // Lattice values give the net back.
  std::array<Rational, B::count> values;
  for (std::size_t i = 0; i < B::count; ++i) {
    std::array<Rational, Dim + 1> at;
    for (std::size_t k = 0; k <= Dim; ++k) at[k] = Rational(B::indices[i][k], Degree);
    values[i] = value_at(b, at);
  }
  REQUIRE(simplex_net_from_values<Rational, Dim, Degree>(values).c == b.c);
}

template <int Dim, int Degree>
void require_simplex_parts(Draw& d) {
  const auto b = draw_net<SimplexNet<Rational, Dim, Degree>>(d);
  const auto l = barycentric<Dim + 1>(d);
  for (std::size_t i = 0; i <= Dim; ++i)
    for (std::size_t j = 0; j <= Dim; ++j) {
      if (i == j) continue;
      const Rational t(d.integer(1, 63), 64);
      const auto parts = split(b, i, j, t);
      auto near = l, far = l;
      near[i] += (1 - t) * l[j];
      near[j] = t * l[j];
      far[i] = (1 - t) * l[i];
      far[j] += t * l[i];
      REQUIRE(value_at(parts.near, l) == value_at(b, near));
      REQUIRE(value_at(parts.far, l) == value_at(b, far));
      // An edge of the whole, and the same edge of a part.
      const auto edge = restricted<1>(b, {i, j});
      const Rational s = small(d);
      std::array<Rational, Dim + 1> on{};
      on[i] = 1 - s;
      on[j] = s;
      REQUIRE(value_at(edge, {1 - s, s}) == value_at(b, on));
      REQUIRE(restricted<1>(parts.near, {i, j}).c == split(edge, 0, 1, t).near.c);
      REQUIRE(restricted<1>(parts.far, {i, j}).c == split(edge, 0, 1, t).far.c);
    }
  if constexpr (Dim == 3) {
    const auto face = restricted<2>(b, {3, 0, 2});
    const auto m = barycentric<3>(d);
    REQUIRE(value_at(face, m) == value_at(b, {m[1], 0, m[2], m[0]}));
    REQUIRE(restricted<2>(split(b, 0, 1, Rational(1, 3)).near, {0, 2, 3}).c ==
            restricted<2>(b, {0, 2, 3}).c);
  }
}

template <int... N>
void require_box_laws(Draw& d) {
  using B = BoxBasis<N...>;
  constexpr std::size_t kDim = sizeof...(N);
  require_basis<B>();
  const auto b = draw_net<BoxNet<Rational, N...>>(d);
  std::array<Rational, kDim> x;
  for (Rational& t : x) t = small(d);
  const Rational value = by_definition(b, x);
  const auto g = value_and_gradient_at(b, x);
  REQUIRE(value_at(b, x) == value);
  REQUIRE(g.value == value);
  REQUIRE(value_at(derivative<0>(b), x) == g.gradient[0]);
  REQUIRE(value_at(derivative<kDim - 1>(b), x) == g.gradient[kDim - 1]);
  REQUIRE(value_at(raised<kDim - 1>(b), x) == value);
  const auto other = draw_net<BoxNet<Rational, N...>>(d);
  REQUIRE(value_at(b * other, x) == value * value_at(other, x));
  for (std::size_t axis = 0; axis < kDim; ++axis) {
    const Rational t(d.integer(1, 9), 10);
    const auto parts = split(b, axis, t);
    auto low = x, high = x;
    low[axis] = t * x[axis];
    high[axis] = t + (1 - t) * x[axis];
    REQUIRE(value_at(parts.low, x) == value_at(b, low));
    REQUIRE(value_at(parts.high, x) == value_at(b, high));
  }
  std::array<Rational, B::count> values;
  for (std::size_t i = 0; i < B::count; ++i) {
    std::array<Rational, kDim> at;
    for (std::size_t k = 0; k < kDim; ++k)
      at[k] = Rational(static_cast<int>(B::indices[i][k]), static_cast<int>(B::degrees[k]));
    values[i] = value_at(b, at);
  }
  REQUIRE(box_net_from_values<Rational, N...>(values).c == b.c);
}

}  // namespace

TEST_CASE("Bernstein bases: the documented order") {
  using Index = SimplexBasis<2, 2>::Index;
  CHECK(SimplexBasis<2, 2>::indices ==
        std::array<Index, 6>{{{2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0}, {0, 1, 1}, {0, 0, 2}}});
  CHECK(SimplexBasis<1, 3>::weights == std::array<double, 4>{1, 3, 3, 1});
  CHECK(SimplexBasis<3, 6>::count == 84);
  CHECK(BoxBasis<3, 3, 3>::count == 64);
  CHECK(BoxBasis<1, 2>::position({1, 0}) == 1);
  CHECK(BoxBasis<1, 2>::position({0, 1}) == 2);
  // Positions do not depend on the degree.
  for (std::size_t i = 0; i < SimplexBasis<3, 4>::count; ++i) {
    auto a = SimplexBasis<3, 4>::indices[i];
    ++a[0];
    CHECK(SimplexBasis<3, 5>::position(a) == i);
  }
}

TEST_CASE("Bernstein nets on simplices: values, gradients, degrees, products, lattices") {
  Draw d(810);
  for (std::uint64_t i = 0; i < scaled(5); ++i) {
    require_simplex_laws<1, 1>(d);
    require_simplex_laws<1, 5>(d);
    require_simplex_laws<2, 1>(d);
    require_simplex_laws<2, 4>(d);
    require_simplex_laws<3, 2>(d);
    require_simplex_laws<3, 3>(d);
  }
}

TEST_CASE("Bernstein nets on simplices: parts, edges, faces") {
  Draw d(811);
  for (std::uint64_t i = 0; i < scaled(5); ++i) {
    require_simplex_parts<1, 4>(d);
    require_simplex_parts<2, 3>(d);
    require_simplex_parts<3, 2>(d);
    require_simplex_parts<3, 4>(d);
  }
}

TEST_CASE("Bernstein nets on boxes: values, gradients, parts, products, lattices") {
  Draw d(812);
  for (std::uint64_t i = 0; i < scaled(5); ++i) {
    require_box_laws<4>(d);
    require_box_laws<3, 3>(d);
    require_box_laws<3, 2, 1>(d);
    require_box_laws<1, 1, 2>(d);
    const auto b = draw_net<BoxNet<Rational, 3, 2, 1>>(d);
    const Rational s = small(d), t = small(d);
    for (const bool high : {false, true}) {
      REQUIRE(value_at(restricted<0>(b, high), {s, t}) == value_at(b, {Rational(high), s, t}));
      REQUIRE(value_at(restricted<1>(b, high), {s, t}) == value_at(b, {s, Rational(high), t}));
      REQUIRE(value_at(restricted<2>(b, high), {s, t}) == value_at(b, {s, t, Rational(high)}));
    }
    // A partial derivative is one: its net over a line is the line's derivative.
    const auto line = restricted<1>(restricted<2>(b, true), false);
    REQUIRE(value_at(derivative<0>(line), {s}) ==
            value_at(derivative<0>(b), {s, Rational(0), Rational(1)}));
  }
  // d/dx of x(1 - x)^2 at 1/3: (1 - x)(1 - 3x) = 0, at 0: 1.
  BoxNet<Rational, 3> bump;
  bump.c = {0, Rational(1, 3), 0, 0};
  CHECK(value_and_gradient_at(bump, {Rational(1, 3)}).gradient[0] == 0);
  CHECK(value_and_gradient_at(bump, {Rational(0)}).gradient[0] == 1);
}

TEST_CASE("de Casteljau in doubles stays within its bound of the exact value") {
  // Degree n, convex weights: every level rounds Dim + 1 products and Dim sums.
  double worst = 0;
  for (const Family family : {Family::generic, Family::nearly_equal, Family::mixed_scales}) {
    Draw d(820 + static_cast<std::uint64_t>(family));
    for (std::uint64_t i = 0; i < scaled(200); ++i) {
      SimplexNet<double, 3, 3> b;
      SimplexNet<Rational, 3, 3> exact;
      double size = 0;
      for (std::size_t k = 0; k < b.c.size(); ++k) {
        exact.c[k] = b.c[k] = draw(d, family);
        size = std::max(size, std::fabs(b.c[k]));
      }
      std::array<double, 4> l;
      for (double& x : l) x = d.integer(0, 16) / 64.0;
      l[0] = 1 - l[1] - l[2] - l[3];
      const std::array<Rational, 4> at = {l[0], l[1], l[2], l[3]};
      const Rational error = Rational(value_at(b, l)) - value_at(exact, at);
      worst = std::max(worst, std::fabs(error.convert_to<double>()) / size);
    }
  }
  CHECK(worst <= 3 * 5 * 0x1p-53);
  CHECK(worst > 0);
}
