// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of the checker of smooth ridges: cheaper formulas against the general ones.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/ridges_smooth/immersion.hpp"
#include "certify/ridges_smooth/slopes.hpp"
#include "certify/ridges_smooth/surface.hpp"
#include "tests/kernel/triangle_points.hpp"

namespace {

using namespace crest::kernel;
using namespace crest::tests;
using namespace crest::certify::smooth;

using F = Local<Model3, 1>;
using Surface4 = Triple<Jet<Model3, 2, 4>>;

double middle(const Model3& m) {
  const Range r = m.range();
  REQUIRE(r.high - r.low < 1e-6 * (1 + std::fabs(r.low)));
  return r.low / 2 + r.high / 2;
}
bool is_near(double a, double b) {
  return std::fabs(a - b) <= 1e-6 * (1 + std::fabs(a) + std::fabs(b));
}
/// Value and derivatives of a and s b.
void require_equal(const F& a, const F& b, double s) {
  REQUIRE(is_near(middle(a.value()), s * middle(b.value())));
  REQUIRE(is_near(middle(a.d(1, 0)), s * middle(b.d(1, 0))));
  REQUIRE(is_near(middle(a.d(0, 1)), s * middle(b.d(0, 1))));
}

Surface4 draw_surface(Draw& d, std::size_t height) {
  Surface4 x;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < (k == height ? x[k].kCount : 3); ++i) x[k].set(i, d.uniform() * 2);
  return x;
}
/// Of z = X_m over the other two in cyclic order.
double determinant(const Surface4& x, std::size_t m) {
  const auto &p = x[(m + 1) % 3], &q = x[(m + 2) % 3];
  return middle(p[2]) * middle(q[1]) - middle(p[1]) * middle(q[2]);
}
std::array<double, 2> regular_direction(const Forms<Model3, 1>& f) {
  const auto a = shape(f);
  for (int k = 0; k < 128; k += 8)
    if (is_positive(s_of(f.i, a, direction(k)))) return direction(k);
  FAIL("an umbilic");
  return {};
}
std::array<Pair<F>, 2> principal_vectors(const Forms<Model3, 1>& f,
                                         const std::array<double, 2>& w) {
  const auto v = principal(shape(f), w);
  return {v, turned(f.i, v)};
}

}  // namespace

TEST_CASE("smooth ridges: height fields have the forms of immersions") {
  Draw d(72);
  for (std::uint64_t i = 0; i < scaled(200); ++i) {
    const auto m = static_cast<std::size_t>(d.integer(0, 2));
    const Surface4 x = draw_surface(d, m);
    const double factor = std::fabs(determinant(x, m));
    if (factor < 0.1) continue;
    const auto graph = surface_forms<1, 4, Model3>(x), full = immersion_forms<1, 4, Model3>(x);
    REQUIRE(graph.graph);
    REQUIRE_FALSE(full.graph);
    for (std::size_t k = 0; k < 3; ++k) {
      require_equal(full.i[k], graph.i[k], 1);
      require_equal(full.l[k], graph.l[k], factor);
    }
    for (std::size_t k = 0; k < 4; ++k) require_equal(full.t[k], graph.t[k], factor);
    FirstSecond<Model3, 1> second;
    fill_surface<1, 4>(x, second);
    for (std::size_t k = 0; k < 3; ++k) require_equal(second.l[k], graph.l[k], 1);
    const auto w = regular_direction(full);
    const auto a = principal_vectors(full, w), b = principal_vectors(graph, w);
    for (std::size_t j = 0; j < 2; ++j)
      require_equal(extremality(full, a[j]), extremality(graph, b[j]), factor);
  }
}

TEST_CASE("smooth ridges: no height field without two affine coordinates that span") {
  Draw d(73);
  Surface4 x = draw_surface(d, 2);
  REQUIRE(height_field<Model3>(x));
  x[1] = x[0];
  REQUIRE_FALSE(height_field<Model3>(x));
  x = draw_surface(d, 2);
  x[0].set(4, 1.0);
  REQUIRE_FALSE(height_field<Model3>(x));
  // Two affine ones of which the first is constant: over the other pair it is none.
  x = draw_surface(d, 2);
  x[0] = Jet<Model3, 2, 4>::constant(1.0);
  REQUIRE_FALSE(height_field<Model3>(x));
}

TEST_CASE("smooth ridges: slopes have the zeros of principal vectors") {
  Draw d(74);
  std::array<int, 2> seen{};
  for (std::uint64_t i = 0; i < scaled(200); ++i) {
    Surface4 x = draw_surface(d, 2);
    if (d.coin()) x[0].set(4, d.uniform());  // not a height field
    const auto f = surface_forms<1, 4, Model3>(x);
    const auto v = principal_vectors(f, regular_direction(f));
    const bool steep = middle(shape(f).a.value()) < 0;
    const auto s = slopes(shape(f), steep);
    ++seen[steep];
    for (std::size_t j = 0; j < 2; ++j) {
      const Pair<double> at = {middle(v[j][0].value()), middle(v[j][1].value())};
      const bool second = steep == (j == 0);  // the component that is 1
      const double one = at[second], slope = at[!second] / one;
      REQUIRE(is_near(middle(j == 0 ? s.blue : s.red), slope));
      REQUIRE(is_near(middle(extremality(f, v[j]).value()) / std::pow(one, 5),
                      middle(extremality(f, s, j))));
    }
  }
  REQUIRE(seen[0] > 0);
  REQUIRE(seen[1] > 0);
}
