// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/chart.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "algorithms/smooth_ridges/initial_mesh.hpp"
#include "tests/smooth_ridges/samples.hpp"
#include "tests/support/random.hpp"

namespace crest::smooth_ridges {
namespace {

using Model = kernel::TaylorModel<3>;

struct Barycentric {
  double l1, l2;
  double l0() const { return 1 - l1 - l2; }
};

Barycentric random_point(crest::tests::Random& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Barycentric l{uniform(random), uniform(random)};
  if (l.l1 + l.l2 > 1) l = {1 - l.l1, 1 - l.l2};
  return l;
}

/// The polynomial's value.
double at(const Model& m, const Barycentric& l) {
  const double u = l.l1 - (l.l0() + l.l2) / 2, v = l.l2 - (l.l0() + l.l1) / 2;
  double sum = 0;
  for (std::size_t k = 0; k < Model::kCount; ++k)
    sum += m.c[k] * std::pow(u, Model::kTable.exponents[k][0]) *
           std::pow(v, Model::kTable.exponents[k][1]);
  return sum;
}

/// Phi(l), by Newton's method in doubles.
Vec3 phi(Projection& f, const std::array<Vertex, 3>& c, const Barycentric& l) {
  Vec3 p{}, m{};
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = l.l0() * c[0][k] + l.l1 * c[1][k] + l.l2 * c[2][k];
    m[k] = l.l0() * c[0][3 + k] + l.l1 * c[1][3 + k] + l.l2 * c[2][3 + k];
  }
  const auto x = f.along(p, m, 1);
  REQUIRE(x);
  return *x;
}

}  // namespace

TEST_CASE("charts enclose the surface and its tangents") {
  crest::tests::Random random(3);
  for (const Sample& sample : closed_samples()) {
    INFO(sample.name);
    const Triangulation mesh = initial_mesh(sample.surface, 4000);
    Charts<Model> charts(sample.surface);
    Projection f(sample.surface);
    std::size_t proven = 0;
    double relative = 0;
    for (Index face = 0; face < mesh.faces().size(); face += 3) {
      const auto corners = mesh.corners(face);
      auto chart = charts(corners);
      if (!chart) continue;
      ++proven;
      charts.tangents(*chart, corners);
      const Vec3 edge = step(position(corners[0]), -1, position(corners[1]));
      relative += chart->s.radius / length(edge);
      for (int i = 0; i < 5; ++i) {
        const Barycentric l = random_point(random);
        const Vec3 x = phi(f, corners, l);
        const double d = 1e-5;
        const Vec3 x1 = phi(f, corners, {l.l1 + d, l.l2}), y1 = phi(f, corners, {l.l1 - d, l.l2});
        const Vec3 x2 = phi(f, corners, {l.l1, l.l2 + d}), y2 = phi(f, corners, {l.l1, l.l2 - d});
        for (std::size_t k = 0; k < 3; ++k) {
          REQUIRE(std::fabs(at(chart->x[k], l) - x[k]) <= chart->x[k].radius + 1e-13);
          const double t1 = (x1[k] - y1[k]) / (2 * d), t2 = (x2[k] - y2[k]) / (2 * d);
          REQUIRE(std::fabs(at(chart->dx[0][k], l) - t1) <= chart->dx[0][k].radius + 1e-8);
          REQUIRE(std::fabs(at(chart->dx[1][k], l) - t2) <= chart->dx[1][k].radius + 1e-8);
        }
      }
    }
    CHECK(proven > mesh.faces().size() / 4);
    CHECK(relative < 0.1 * static_cast<double>(proven));
  }
}

TEST_CASE("charts get sharper by the order of their models") {
  const Surface s = closed_samples()[0].surface;
  Projection f(s);
  Charts<Model> charts(s);
  const auto radius = [&](double size) {
    std::array<Vertex, 3> c;
    const std::array<Vec3, 3> around = {
        {{0.6, 0.7, 0.5}, {0.6 + size, 0.7, 0.5}, {0.6, 0.7 + size, 0.5}}};
    for (std::size_t k = 0; k < 3; ++k) c[k] = f.vertex(*f.onto(around[k], 3));
    if (dot(cross(step(position(c[1]), -1, position(c[0])),
                  step(position(c[2]), -1, position(c[0]))),
            normal(c[0])) < 0)
      std::swap(c[1], c[2]);
    const auto chart = charts(c);
    REQUIRE(chart);
    return chart->s.radius;
  };
  CHECK(radius(0.1) / radius(0.05) > 12);
  CHECK(radius(0.05) / radius(0.025) > 12);
}

TEST_CASE("charts are refused where the fibres do not meet the surface once") {
  const Surface s = Surface::implicit("x^2 + y^2 + z^2 - 1", {-2, 2, -2, 2, -2, 2});
  Projection f(s);
  Charts<Model> charts(s);
  const auto face = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::array<Vertex, 3>{f.vertex(*f.onto(a, 3)), f.vertex(*f.onto(b, 3)),
                                 f.vertex(*f.onto(c, 3))};
  };
  const Vec3 a = {1, 0.1, 0.1}, b = {0.9, 0.3, 0.1}, c = {0.9, 0.1, 0.35};
  CHECK(charts(face(a, b, c)));
  CHECK_FALSE(charts(face(a, c, b)));                             // turned
  CHECK_FALSE(charts(face({1, 0, 0}, {-1, 0.1, 0}, {0, 1, 1})));  // through the middle
  auto off = face(a, b, c);
  for (Vertex& v : off)
    for (std::size_t k = 0; k < 3; ++k) v[k] += 5;  // no zero near
  CHECK_FALSE(charts(off));
  auto flipped = face(a, b, c);
  for (Vertex& v : flipped)
    for (std::size_t k = 3; k < 6; ++k) v[k] = -v[k];
  CHECK_FALSE(charts(flipped));
}

TEST_CASE("parametric charts are linear in lifted coordinates") {
  const Surface s = parametric_torus();
  const Triangulation mesh = initial_mesh(s, 100);
  Charts<Model> charts(s);
  for (Index f = 0; f < mesh.faces().size(); ++f) {
    const auto corners = mesh.corners(f);
    const auto chart = charts(corners);
    REQUIRE(chart);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 2; ++i)
        REQUIRE(chart->x[i].at_corner(static_cast<int>(k)).contains(corners[k][i]));
    for (std::size_t i = 0; i < 2; ++i)
      REQUIRE(chart->dx[0][i].range().contains(corners[1][i] - corners[0][i]));
  }
}

}  // namespace crest::smooth_ridges
