// SPDX-License-Identifier: GPL-3.0-or-later
// Jets of the checker of smooth ridges: other coordinates, implicit functions.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/ridges_smooth/implicit_impl.hpp"
#include "certify/ridges_smooth/substitution.hpp"
#include "tests/kernel/triangle_points.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;
using namespace crest::certify;
using namespace crest::certify::smooth;

/// The polynomial with a jet's coefficients at three jets.
template <class Coefficient, class Result, int n>
Result polynomial_at(const Jet<Coefficient, 3, n>& f, const std::array<Result, 3>& x) {
  Result sum;
  for (std::size_t b = 0; b < f.kCount; ++b) {
    Result term = Result::constant(f[b]);
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < f.kTables.kMonomials.exponents[b][i]; ++k) term = term * x[i];
    sum = sum + term;
  }
  return sum;
}

template <int Order, int n>
void check_frames(Draw& d) {
  using Model = TaylorModel<Order>;
  using Exact = Jet<Rational, 3, n>;
  SmoothFaceRecord record{};
  do {
    const int most = d.coin() ? 1 : 127;
    for (auto& x : record.frame) x = static_cast<std::int8_t>(d.integer(-most, most));
  } while (record.frame == decltype(record.frame){});
  const Frame frame = frame_of(record);
  const TrianglePoint at = draw_triangle_point(d);
  Jet<Model, 3, n> f;
  Exact values;  // of the functions at the point
  for (std::size_t b = 0; b < f.kCount; ++b) {
    if (d.integer(0, 2) == 0) continue;
    Model m;
    for (double& c : m.c) c = d.coin() ? 0 : d.uniform() * std::exp2(d.integer(-30, 30));
    m.radius = d.coin() ? 0 : std::exp2(d.integer(-60, 0));
    f.set(b, m);
    values.set(b, polynomial(m, at) + Rational(m.radius) * Rational(d.integer(-4, 4)) / 4);
  }
  std::array<Exact, 3> x;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      x[i] = x[i] + Exact::variable(static_cast<int>(k), Rational(0)) *
                        Exact::constant(Rational(frame[k][i]));
  const Exact expected = polynomial_at(values, x);
  const auto g = in_frame(f, frame);
  for (std::size_t a = 0; a < g.kCount; ++a) REQUIRE(encloses(g[a], at, expected[a]));
}

template <int n>
void check_implicit(Draw& d) {
  using Plane = Jet<double, 2, n>;
  const auto axis = static_cast<std::size_t>(d.integer(0, 2));
  Jet<double, 3, n> f;
  const bool sparse = d.coin();
  for (std::size_t b = 1; b < f.kCount; ++b)
    if (!sparse || d.coin()) f.set(b, d.uniform());
  f.set(3 - axis, d.coin() ? 1.0 : -2.0);
  const auto h = implicit_function<double, n>(f, axis);
  Plane height;
  REQUIRE_FALSE(h.has(0));
  for_each_bit(h.mask(), [&](std::size_t k) { height.set(k, h[k]); });
  std::array<Plane, 3> x;
  x[axis] = height;
  x[(axis + 1) % 3] = Plane::variable(0, 0.0);
  x[(axis + 2) % 3] = Plane::variable(1, 0.0);
  const Plane zero = polynomial_at(f, x);
  double size = 1;
  for_each_bit(h.mask(), [&](std::size_t k) { size = std::fmax(size, std::fabs(h[k])); });
  for (std::size_t k = 0; k < zero.kCount; ++k)
    REQUIRE(std::fabs(zero[k]) < 1e-12 * std::pow(size, n));
}

}  // namespace

TEST_CASE("smooth ridges: derivatives in another frame hold the exact ones") {
  Draw d(71);
  for (std::uint64_t i = 0; i < scaled(60); ++i) {
    check_frames<3, 3>(d);
    check_frames<4, 4>(d);
    check_frames<4, 3>(d);
    check_frames<5, 5>(d);
  }
}

TEST_CASE("smooth ridges: F vanishes along its implicit function") {
  Draw d(72);
  for (std::uint64_t i = 0; i < scaled(300); ++i) {
    check_implicit<3>(d);
    check_implicit<4>(d);
    check_implicit<5>(d);
  }
}
