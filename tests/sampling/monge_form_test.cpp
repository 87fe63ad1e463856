// SPDX-License-Identifier: GPL-3.0-or-later
// Exact Monge forms against closed forms, finite differences, and CGAL's jet fitting.
#define CGAL_EIGEN3_ENABLED 1
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/sampling/mesh_surface.hpp"

namespace crest::sampling {
namespace {

using kernel::MongeForm;

const std::vector<std::string> kCurved = {"ellipsoid",       "blend",          "torus",
                                          "perturbed-torus", "quartic-sphere", "cylinder",
                                          "umbilic-patch"};

/// Height of the surface over p + x d1 + y d2 along n, from values of F alone.
Real height(const Surface& s, const Point& p, const Point& d1, const Point& d2, const Point& n,
            Real x, Real y, Real reach) {
  const Point foot = p + x * d1 + y * d2;
  Real low = -reach, high = reach;
  REQUIRE(s.gradient(foot + low * n).value < 0);
  REQUIRE(s.gradient(foot + high * n).value > 0);
  for (int step = 0; step < 90; ++step) {
    const Real middle = (low + high) / 2;
    (s.gradient(foot + middle * n).value < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

Real polynomial(const MongeForm& m, Real x, Real y) {
  return (m.k1 * x * x + m.k2 * y * y) / 2 +
         (m.b0 * x * x * x + 3 * m.b1 * x * x * y + 3 * m.b2 * x * y * y + m.b3 * y * y * y) / 6 +
         (m.c0 * x * x * x * x + 4 * m.c1 * x * x * x * y + 6 * m.c2 * x * x * y * y +
          4 * m.c3 * x * y * y * y + m.c4 * y * y * y * y) /
             24;
}

double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

TEST_CASE("frames are orthonormal, principal and outward") {
  for (const std::string& name : kCurved) {
    const Surface s = make_surface(name, {}, true);
    const SurfaceSample mesh = sample(s, 300, true);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      INFO(name << " vertex " << v);
      const MongeForm& m = mesh.forms[v];
      REQUIRE(std::abs(dot(m.d1, m.n)) < 4e-16);
      REQUIRE(std::abs(dot(m.d1, m.d1) - 1) < 6e-16);
      REQUIRE(std::abs(dot(m.n, m.n) - 1) < 6e-16);
      REQUIRE(m.k1 >= m.k2);
      const Point g = s.gradient(to_point(mesh.points[v])).gradient;
      REQUIRE(static_cast<double>(sampling::dot(g, to_point(m.n)) / norm(g)) ==
              Approx(1).margin(1e-15));
    }
  }
}

TEST_CASE("the polynomial's error is of fifth order") {
  for (const std::string& name : kCurved) {
    const Surface s = make_surface(name, {}, true);
    const SurfaceSample mesh = sample(s, 60, true);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const MongeForm& m = mesh.forms[v];
      const Point p = to_point(mesh.points[v]);
      const Point n = to_point(m.n);
      const Point d1 = to_point(m.d1), d2 = to_point(minimal_direction(m));
      const Real scale = 1 / std::max(std::abs(m.k1), std::abs(m.k2));
      const auto error = [&](Real h, Real cosine, Real sine) {
        const Real x = h * cosine, y = h * sine;
        return std::abs(height(s, p, d1, d2, n, x, y, scale / 10) - polynomial(m, x, y));
      };
      for (int k = 0; k < 5; ++k) {
        const Real cosine = std::cos(Real(k) + Real(0.3)), sine = std::sin(Real(k) + Real(0.3));
        const Real h = scale / 100;
        const Real coarse = error(h, cosine, sine), fine = error(h / 4, cosine, sine);
        INFO(name << " vertex " << v << " direction " << k << ": " << double(coarse) << " "
                  << double(fine));
        // A wrong fourth-order coefficient would leave 1/256, a wrong third-order one 1/64.
        REQUIRE(fine <= coarse / 600 + 1e-15L * scale);
        REQUIRE(coarse < 1e-5L * scale);
      }
    }
  }
}

TEST_CASE("third-order coefficients are the derivatives of the curvatures") {
  for (const std::string name : {"ellipsoid", "blend", "perturbed-torus", "quartic-sphere"}) {
    const Surface s = make_surface(name, {}, true);
    const SurfaceSample mesh = sample(s, 100, true);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const MongeForm& m = mesh.forms[v];
      const double scale = std::max(std::abs(m.k1), std::abs(m.k2));
      if (m.k1 - m.k2 < 0.2 * scale) continue;
      const double h = 1e-4 / scale;
      const auto at = [&](const Vec3& d, double t) {
        // Newton's step along the gradient from the tangent plane: third order of contact is not
        // needed, any curve tangent to d gives the derivative.
        Point q = to_point(mesh.points[v]) + Real(t) * to_point(d);
        for (int i = 0; i < 4; ++i) {
          const ValueAndGradient g = s.gradient(q);
          q = q - (g.value / sampling::dot(g.gradient, g.gradient)) * g.gradient;
        }
        return s.monge_form(to_vec3(q));
      };
      const Vec3 d2 = minimal_direction(m);
      const MongeForm a = at(m.d1, -h), b = at(m.d1, h), c = at(d2, -h), d = at(d2, h);
      const double unit = scale * scale * 10;
      INFO(name << " vertex " << v);
      REQUIRE(m.b0 == Approx((b.k1 - a.k1) / (2 * h)).margin(1e-5 * unit));
      REQUIRE(m.b2 == Approx((b.k2 - a.k2) / (2 * h)).margin(1e-5 * unit));
      REQUIRE(m.b1 == Approx((d.k1 - c.k1) / (2 * h)).margin(1e-5 * unit));
      REQUIRE(m.b3 == Approx((d.k2 - c.k2) / (2 * h)).margin(1e-5 * unit));
    }
  }
}

TEST_CASE("the level-set formula of b0 on a quadric") {
  // F is quadratic, so F_ttt = 0 and b0 = -3 k1 (d1.H.n) / |grad F|.
  const double axes[3] = {1, 1.5, 2};
  const Surface s = make_surface("ellipsoid", {1, 1.5, 2}, false);
  const SurfaceSample mesh = sample(s, 500, true);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const MongeForm& m = mesh.forms[v];
    double thn = 0, tht = 0, norm = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double h = 2 / (axes[i] * axes[i]);
      thn += m.d1[i] * h * m.n[i];
      tht += m.d1[i] * h * m.d1[i];
      norm += h * h * mesh.points[v][i] * mesh.points[v][i];
    }
    norm = std::sqrt(norm);
    REQUIRE(m.k1 == Approx(-tht / norm).epsilon(1e-13));
    REQUIRE(m.b0 == Approx(-3 * m.k1 * thn / norm).epsilon(1e-12).margin(1e-14));
  }
}

TEST_CASE("the umbilics of an ellipsoid") {
  for (const auto& axes : std::vector<std::vector<double>>{{1, 1.5, 2}, {1, 1.2, 3}, {2, 5, 5.5}}) {
    const double a = axes[0], b = axes[1], c = axes[2];
    const double x = a * std::sqrt((b * b - a * a) / (c * c - a * a));
    const double z = c * std::sqrt((c * c - b * b) / (c * c - a * a));
    const Surface s = make_surface("ellipsoid", axes, false);
    for (const double sx : {-1, 1})
      for (const double sz : {-1, 1}) {
        const MongeForm m = s.monge_form({sx * x, 0, sz * z});
        REQUIRE(m.k1 - m.k2 < 1e-14 * std::abs(m.k1) * c / a);
        REQUIRE(m.k1 == Approx(-a * c / (b * b * b)).epsilon(1e-12));
      }
  }
}

TEST_CASE("degenerate surfaces have exact zeros") {
  for (const bool rotate : {false, true}) {
    for (const MongeForm& m : sample("plane", {}, 50, rotate).forms)
      REQUIRE((m.k1 == 0 && m.k2 == 0 && m.b0 == 0 && m.b3 == 0 && blue_p(m) == 0));
    for (const MongeForm& m : sample("cylinder", {3}, 50, rotate).forms)
      REQUIRE((m.k1 == 0 && m.k2 == -1 / 3.0 && m.b0 == 0 && m.b3 == 0 && red_p(m) == 0));
    for (const MongeForm& m : sample("sphere", {3}, 50, rotate).forms)
      REQUIRE((m.k1 == m.k2 && m.b0 == 0 && m.b3 == 0 && blue_p(m) == 0 && red_p(m) == 0));
    for (const MongeForm& m : sample("torus", {2, 1}, 50, rotate).forms)
      REQUIRE((m.k2 == -1 && m.k1 > -1 && m.b0 == 0 && m.b3 == 0 && red_p(m) == 0));
  }
}

TEST_CASE("CGAL's jet fitting on a tiny dense patch agrees") {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Fitting = CGAL::Monge_via_jet_fitting<Kernel>;
  for (const std::string name : {"ellipsoid", "blend", "perturbed-torus", "quartic-sphere"}) {
    const Surface s = make_surface(name, {}, true);
    const SurfaceSample mesh = sample(s, 100, true);
    int compared = 0;
    for (std::size_t v = 0; v < mesh.points.size(); v += 7) {
      const MongeForm& m = mesh.forms[v];
      const double scale = std::max(std::abs(m.k1), std::abs(m.k2));
      if (m.k1 - m.k2 < 0.3 * scale) continue;
      std::vector<Kernel::Point_3> points = {
          {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]}};
      const Point d1 = to_point(m.d1), d2 = to_point(minimal_direction(m));
      for (int k = 1; k < 120; ++k) {  // sunflower
        const Real r = 0.04L / scale * std::sqrt(Real(k) / 120), t = Real(k) * 2.39996L;
        const Vec3 q = to_vec3(
            s.project(to_point(mesh.points[v]) + r * std::cos(t) * d1 + r * std::sin(t) * d2));
        points.emplace_back(q[0], q[1], q[2]);
      }
      Fitting fitting;
      auto fit = fitting(points.begin(), points.end(), 6, 4);
      fit.comply_wrt_given_normal({m.n[0], m.n[1], m.n[2]});
      const auto d = fit.maximal_principal_direction();
      const double sign = d.x() * m.d1[0] + d.y() * m.d1[1] + d.z() * m.d1[2] > 0 ? 1 : -1;
      const double b[] = {m.b0, m.b1, m.b2, m.b3}, c[] = {m.c0, m.c1, m.c2, m.c3, m.c4};
      INFO(name << " vertex " << v);
      REQUIRE(fit.principal_curvatures(0) == Approx(m.k1).margin(1e-5 * scale));
      REQUIRE(fit.principal_curvatures(1) == Approx(m.k2).margin(1e-5 * scale));
      for (std::size_t i = 0; i < 4; ++i)
        REQUIRE(sign * fit.third_order_coefficients(i) ==
                Approx(b[i]).margin(3e-3 * scale * scale));
      for (std::size_t i = 0; i < 5; ++i)
        REQUIRE(fit.fourth_order_coefficients(i) ==
                Approx(c[i]).epsilon(0.02).margin(0.1 * scale * scale * scale));
      ++compared;
    }
    REQUIRE(compared >= 3);
  }
}

}  // namespace crest::sampling
