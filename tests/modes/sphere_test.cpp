// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/sphere.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "algorithms/modes/face_critical_points.hpp"
#include "algorithms/modes/mode_geometry.hpp"
#include "algorithms/modes/theorem_a.hpp"
#include "tests/modes/reference_fields.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest;
using namespace crest::tests;
using namespace crest::modes;
using kernel::Rational;
using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

std::array<Tensor, 4> corners_of(const LinearField& f, double size = 1) {
  return {tensor_at(f, {0, 0, 0}), tensor_at(f, {size, 0, 0}), tensor_at(f, {0, size, 0}),
          tensor_at(f, {0, 0, size})};
}
std::array<const Tensor*, 4> pointers(const std::array<Tensor, 4>& t) {
  return {&t[0], &t[1], &t[2], &t[3]};
}
Vec3 times(const Tensor& a, const Vec3& v) {
  return {a[0] * v[0] + a[3] * v[1] + a[5] * v[2], a[3] * v[0] + a[1] * v[1] + a[4] * v[2],
          a[5] * v[0] + a[4] * v[1] + a[2] * v[2]};
}
Vec3 random_direction(Random& random) {
  std::normal_distribution<double> normal;
  const Vec3 v{normal(random), normal(random), normal(random)};
  return (1 / kernel::norm(v)) * v;
}

}  // namespace

TEST_CASE("sphere: both points of a medium eigenvector, their modes and signs") {
  Random random(kSeed + 51);
  std::array<int, 3> points{};  // two negative, one of each, two positive
  int real = 0, complex = 0;
  for (const LinearField& f : reference_fields()) {
    const auto corners = corners_of(f);
    const LinearTensors field(corners);
    CHECK(field.characteristic_mode() <= 0);
    for (int i = 0; i < 1000; ++i) {
      const double mu = 0.05 + 0.9 * (i % 19) / 19;
      const Vec3 v = random_direction(random);
      const auto found = mode_points(field, v, mu);
      const double domain = real_domain(field, v, mu);
      CHECK((domain >= 0) == found.has_value());
      // Equation 6 as printed.
      const Matrix3& bar = field.characteristic();
      const Vec3 image{kernel::dot(bar[0], v), kernel::dot(bar[1], v), kernel::dot(bar[2], v)};
      const double alpha = kernel::dot(v, image), sine = sine_of_theta(mu);
      CHECK(domain ==
            Approx(0.5 - kernel::dot(image, image) + (1 - sine * sine) * alpha * alpha / 4)
                .margin(1e-13));
      found ? ++real : ++complex;
      if (!found) continue;
      int sum = 0;
      for (const ModePoint& p : *found) {
        sum += p.sign;
        const Tensor t = blend(corners, p.weights);
        CHECK(mode_of(t) == Approx(p.sign * mu).margin(1e-9));
        const Vec3 w = times(t, v);
        const double scale = std::sqrt(kernel::dot(w, w)) + 1;
        CHECK(kernel::norm(kernel::cross(w, v)) < 1e-9 * scale * 1e3);
      }
      ++points[static_cast<std::size_t>(sum / 2 + 1)];
    }
  }
  // Mostly one of each sign: figure 4's blue; cyan and magenta about as often as each other.
  CHECK(points[1] > 4 * (points[0] + points[2]));
  CHECK(points[0] > 50);
  CHECK(points[2] > 50);
  CHECK(real > 20 * complex);
}

TEST_CASE("sphere: irregular points and the complex domain's boundary") {
  for (const LinearField& f : reference_fields()) {
    const LinearTensors field(corners_of(f));
    const IrregularPoints p = irregular_points(field);
    CHECK(p.a * p.a + p.c * p.c == Approx(1));
    const Vec3 v = p.a * field.frame()[0] + p.c * field.frame()[2];
    CHECK(std::fabs(real_domain(field, v, 0)) < 1e-14);  // rho = 0
    int found = 0;
    for (int i = -50; i <= 50; ++i)
      if (const auto x = boundary_point(field, i / 60.0, 0.6)) {
        ++found;
        const Vec3 w =
            (*x)[0] * field.frame()[0] + (*x)[1] * field.frame()[1] + (*x)[2] * field.frame()[2];
        CHECK(kernel::norm(w) == Approx(1));
        CHECK(std::fabs(real_domain(field, w, 0.6)) < 1e-13);
      }
    CHECK(found > 3);
  }
}

TEST_CASE("sphere: both grids cover it once, with a Jacobian of one sign") {
  for (const LinearField& f : reference_fields()) {
    const IrregularPoints p = irregular_points(LinearTensors(corners_of(f)));
    for (const auto grid : {quad_grid, spheroconal_grid}) {
      constexpr int n = 200;
      double area = 0, least = 1e300;
      const double dt = 2 * std::numbers::pi / n, de = std::numbers::pi / n, h = 1e-6;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double t = (i + 0.5) * dt, e = (j + 0.5) * de;
          const Vec3 a = (1 / (2 * h)) * (grid(p, t + h, e) - grid(p, t - h, e));
          const Vec3 b = (1 / (2 * h)) * (grid(p, t, e + h) - grid(p, t, e - h));
          const double jacobian = -kernel::determinant(grid(p, t, e), a, b);
          area += std::fabs(jacobian) * dt * de;
          least = std::min(least, jacobian * (jacobian == 0 ? 0 : 1));
          if (grid == spheroconal_grid) CHECK(std::fabs(kernel::dot(a, b)) < 1e-7);
        }
      CHECK((least > 0 || least < 0));
      CHECK(area == Approx(4 * std::numbers::pi).epsilon(2e-3));
    }
  }
}

TEST_CASE("mode geometry: normals and curvatures against finite differences") {
  Random random(kSeed + 52);
  std::uniform_real_distribution<double> uniform(0.1, 1);
  const std::array<Vec3, 4> x{{{0, 0, 0}, {1.2, 0.1, 0}, {0.2, 0.9, 0.1}, {0.1, 0.3, 1.1}}};
  for (const LinearField& f : reference_fields()) {
    std::array<Tensor, 4> t;
    for (std::size_t k = 0; k < 4; ++k) t[k] = tensor_at(f, x[k]);
    for (int i = 0; i < 20; ++i) {
      std::array<double, 4> w;
      double sum = 0;
      for (double& b : w) sum += b = uniform(random);
      for (double& b : w) b /= sum;
      const Vec3 at = w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
      const ModeGeometry g = mode_geometry(x, t, w);
      if (kernel::norm(g.gradient) < 0.05) continue;
      const auto mode = [&](const Vec3& p) { return mode_of(tensor_at(f, p)); };
      CHECK(g.mode == Approx(mode(at)));
      constexpr double h = 1e-4;
      for (std::size_t k = 0; k < 3; ++k) {
        Vec3 e{};
        e[k] = h;
        CHECK(g.gradient[k] == Approx((mode(at + e) - mode(at - e)) / (2 * h)).margin(1e-5));
      }
      CHECK(std::fabs(kernel::dot(g.d1, g.d2)) < 1e-12);
      CHECK(std::fabs(kernel::dot(g.d1, g.normal)) < 1e-12);
      // Along a principal direction the level bends by k towards the normal.
      for (const auto& [k, d] : {std::pair{g.k1, g.d1}, {g.k2, g.d2}}) {
        const double second = (mode(at + h * d) + mode(at - h * d) - 2 * mode(at)) / (h * h);
        CHECK(-second / kernel::norm(g.gradient) == Approx(k).margin(1e-3 * (1 + std::fabs(k))));
      }
      const Vec3 s = g.d1 + g.d2;
      const double mixed = (mode(at + h * s) + mode(at - h * s) - 2 * mode(at)) / (h * h);
      CHECK(-mixed / kernel::norm(g.gradient) ==
            Approx(g.k1 + g.k2).margin(1e-3 * (1 + std::fabs(g.k1) + std::fabs(g.k2))));
    }
  }
}

TEST_CASE("theorem A: the critical mode of the reference fields, the node at 143/343 exactly") {
  constexpr std::array<double, 6> expected{.179043, .290890, .915992, .990828, .930450, .925667};
  for (std::size_t f = 0; f < 6; ++f) {
    const auto t = corners_of(reference_fields()[f]);
    const auto c = critical_tensor(pointers(t));
    REQUIRE(c);
    CHECK(std::sqrt(static_cast<double>(c->squared_mode)) == Approx(expected[f]).margin(1e-6));
  }
  // A tet around the origin.
  const std::array<Vec3, 4> x{{{-1, -1, -1}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}};
  std::array<Tensor, 4> t;
  for (std::size_t k = 0; k < 4; ++k) t[k] = tensor_at(node_field(), x[k]);
  const auto c = critical_tensor(pointers(t));
  REQUIRE(c);
  CHECK(c->squared_mode == Rational(143 * 143) / Rational(343 * 343));
  CHECK(c->mode_sign == -1);
  REQUIRE(c->weights);
  for (std::size_t i = 0; i < 3; ++i) {
    Rational at = 0;
    for (std::size_t k = 0; k < 4; ++k) at += (*c->weights)[k] * Rational(x[k][i]);
    CHECK(at == 0);
  }
  for (auto& tensor : t)
    for (double& component : tensor) component = -component;
  CHECK(critical_tensor(pointers(t))->mode_sign == 1);
  // Elsewhere it is not in the tet; dependent corners have none.
  CHECK(!critical_tensor(pointers(corners_of(node_field())))->weights);
  t[3] = t[2];
  CHECK(!critical_tensor(pointers(t)));
}

TEST_CASE("critical points of the mode on a face's plane: degenerate ones are the extrema") {
  Random random(kSeed + 53);
  std::normal_distribution<double> normal;
  std::array<int, 3> seen{};
  int incomplete = 0;
  for (int i = 0; i < 40; ++i) {
    std::array<Tensor, 3> t;
    for (auto& x : t)
      for (double& y : x) y = normal(random);
    int degenerate = 0, others = 0, extremal = 0;
    for (const auto& p : face_critical_points(t)) {
      degenerate += p.degenerate;
      others += !p.degenerate;
      extremal += !p.degenerate && p.extremum;
      if (p.degenerate) CHECK(p.extremum);
    }
    // (4, 3, 0), (2, 3, 1), (2, 1, 0): by Euler's count no other.
    if (degenerate == 4 && others == 3 && extremal == 0)
      ++seen[0];
    else if (degenerate == 2 && others == 3 && extremal == 1)
      ++seen[1];
    else if (degenerate == 2 && others == 1 && extremal == 0)
      ++seen[2];
    else
      ++incomplete;
  }
  CHECK(incomplete <= 2);
  CHECK(seen[0] > 0);
  CHECK(seen[1] > 0);
  CHECK(seen[2] > 0);
}
