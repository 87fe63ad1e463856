// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/standard_errors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/ridges/ridge_cases.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;

TEST_CASE("standard errors: gradients of the principal curvatures are their difference quotients") {
  Draw d(4711);
  for (int trial = 0; trial < 50; ++trial) {
    ridges::Jet jet;
    jet.degree = 4;
    for (double& c : jet.c) c = d.uniform();
    const ridges::PrincipalFrame frame = ridges::principal_frame(jet);
    if (frame.k1 - frame.k2 < 0.1) continue;
    const ridges::CurvatureGradients g = ridges::curvature_gradients(jet, frame);
    for (std::size_t i = 1; i < 6; ++i) {
      constexpr double h = 1e-6;
      ridges::Jet more = jet, less = jet;
      more.c[i] += h;
      less.c[i] -= h;
      const ridges::PrincipalFrame a = ridges::principal_frame(more), b = principal_frame(less);
      CAPTURE(trial, i);
      CHECK(g.k1[i] == Approx((a.k1 - b.k1) / (2 * h)).margin(1e-6));
      CHECK(g.k2[i] == Approx((a.k2 - b.k2) / (2 * h)).margin(1e-6));
    }
  }
}

TEST_CASE("standard errors: those of noisy ellipsoids are the spread of the curvatures") {
  // Errors of noise alone: the support is small enough for truncation not to count.
  const sampling::SurfaceSample s = sampling::sample("ellipsoid", {1, 1.5, 2}, 10000, true);
  const double edge = sampling::mean_edge_length(s.points, s.faces);
  const auto fit = [&](double noise, std::uint64_t seed) {
    auto points = s.points;
    if (noise > 0) sampling::add_normal_noise(points, sampling::normals(s), noise * edge, seed);
    ridges::FitOptions options;
    options.errors = true;
    return ridges::fit_monge_forms(kernel::TriangleMesh(points, s.faces), options);
  };
  const ridges::FitResult clean = fit(0, 0);
  double k1 = 0, k2 = 0, gap = 0, n = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const ridges::FitResult noisy = fit(0.003, seed);
    for (std::size_t v = 0; v < clean.forms.size(); ++v) {
      const kernel::MongeForm &a = noisy.forms[v], &b = clean.forms[v];
      if (b.k1 - b.k2 < 0.2) continue;
      const ridges::CurvatureError& e = noisy.errors[v];
      k1 += std::pow((a.k1 - b.k1) / e.k1, 2);
      k2 += std::pow((a.k2 - b.k2) / e.k2, 2);
      gap += std::pow((a.k1 - a.k2 - b.k1 + b.k2) / e.gap, 2);
      n += 1;
    }
  }
  CHECK(n > 20000);
  for (const double squares : {k1, k2, gap}) {
    CHECK(std::sqrt(squares / n) > 0.85);
    CHECK(std::sqrt(squares / n) < 1.2);
  }
}

TEST_CASE("standard errors: the second fit has a wider support, whatever chooses it") {
  const RidgeCase c = exact_case("ellipsoid", {1, 1.5, 2}, 2500, true);
  ridges::FitOptions by_count, by_rings, by_radius;
  by_rings.rings = 3;
  by_radius.scale = 0.3;
  for (ridges::FitOptions options : {by_count, by_rings, by_radius}) {
    const ridges::FitResult plain = ridges::fit_monge_forms(c.mesh, options);
    options.errors = true;
    const ridges::FitResult fit = ridges::fit_monge_forms(c.mesh, options);
    double narrow = 0, wide = 0;
    for (std::size_t v = 0; v < fit.forms.size(); ++v) {
      REQUIRE(fit.forms[v].k1 == plain.forms[v].k1);  // the first fit is what it was
      REQUIRE(fit.forms[v].c4 == plain.forms[v].c4);
      REQUIRE(fit.errors[v].k1 > 0);
      narrow += std::fabs(fit.forms[v].k1 - c.forms[v].k1);
      wide += std::fabs(fit.errors[v].wide_k1 - c.forms[v].k1);
    }
    CHECK(wide > 1.3 * narrow);  // truncation grows with the support
  }
}

TEST_CASE("standard errors: no fit of degree 4, no finite error") {
  // An octahedron has six points.
  const kernel::TriangleMesh mesh(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  ridges::FitOptions options;
  options.errors = true;
  for (const ridges::CurvatureError& e : ridges::fit_monge_forms(mesh, options).errors) {
    CHECK(std::isinf(e.k1));
    CHECK(std::isinf(e.gap));
  }
}
