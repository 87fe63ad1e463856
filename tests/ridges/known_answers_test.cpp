// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/salience.hpp"
#include "tests/ridges/ridge_cases.hpp"

using namespace crest;
using namespace crest::tests;
using ridges::Colour;
using ridges::EndKind;

namespace {

void require_ellipsoid_graph(const RidgeCase& c) {
  const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
  REQUIRE(g.umbilics.size() == 4);
  for (const ridges::Umbilic& u : g.umbilics) {
    CHECK(u.twice_index == 1);
    CHECK(u.kind == ridges::UmbilicKind::one_ridge);
    CHECK(u.coherent);
  }
  CHECK(g.twice_index_sum == 4);
  const RidgeCounts n = count_ridges(g);
  for (int colour : {0, 1}) {
    CHECK(n.loops[colour] == 1);
    CHECK(n.segments[colour] == 2);
  }
  CHECK(ridges::open_ends(g) == 0);
  for (const ridges::Ridge& r : g.ridges) {  // figure 2: loops elliptic, segments hyperbolic
    CHECK(r.length == Approx(r.loop ? r.elliptic_length : r.hyperbolic_length));
    if (!r.loop) {
      CHECK(r.ends[0].kind == EndKind::umbilic);
      CHECK(r.ends[1].kind == EndKind::umbilic);
      CHECK(r.lead_in.front() == g.umbilics[r.ends[0].umbilic].point);
      CHECK(r.lead_out.back() == g.umbilics[r.ends[1].umbilic].point);
    }
  }
}

}  // namespace

TEST_CASE("ellipsoids: 4 umbilics, 1 loop and 2 segments a colour") {
  const std::vector<std::vector<double>> axes = {{1, 1.5, 2}, {1, 1.2, 1.7}, {0.7, 1, 1.1}};
  for (const auto& a : axes)
    for (int vertices : {2500, 10000}) {
      CAPTURE(a, vertices);
      require_ellipsoid_graph(fitted_case("ellipsoid", a, vertices, true));
      require_ellipsoid_graph(exact_case("ellipsoid", a, vertices, true));
    }
}

TEST_CASE("large ellipsoid: 160 k vertices") {
  require_ellipsoid_graph(fitted_case("ellipsoid", {1, 1.5, 2}, 160000, true));
}

TEST_CASE("blend of two ellipsoids: 6 umbilics of +1/2, 2 of -1/2, all ridges joined") {
  const RidgeCase c = fitted_case("blend", {}, 40000, true);
  const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
  int plus = 0, minus = 0;
  for (const ridges::Umbilic& u : g.umbilics) {
    plus += u.twice_index == 1;
    minus += u.twice_index == -1;
    CHECK(u.coherent);
  }
  CHECK(g.umbilics.size() == 8);
  CHECK(plus == 6);
  CHECK(minus == 2);
  CHECK(g.twice_index_sum == 4);
  CHECK(ridges::open_ends(g) == 0);
}

TEST_CASE("fitted Monge forms converge to the exact ones") {
  double previous = 1;
  for (int vertices : {2500, 10000, 40000}) {
    const RidgeCase exact = exact_case("ellipsoid", {1, 1.5, 2}, vertices, true);
    const auto fitted = ridges::fit_monge_forms(exact.mesh, {});
    double worst = 0;
    for (std::size_t v = 0; v < exact.forms.size(); ++v) {
      CHECK(fitted.quality[v].degree == 4);
      worst = std::max({worst, std::fabs(fitted.forms[v].k1 - exact.forms[v].k1),
                        std::fabs(fitted.forms[v].k2 - exact.forms[v].k2)});
    }
    CHECK(worst < previous / 4);  // order at least 2 in the edge length
    previous = worst;
  }
}

TEST_CASE("noise: with the automatic scale the ellipsoid keeps its umbilics and its salient loop") {
  for (double noise : {0.001, 0.01}) {
    sampling::SurfaceSample s = sampling::sample("ellipsoid", {1, 1.5, 2}, 10000, true);
    const double edge = sampling::mean_edge_length(s.points, s.faces);
    sampling::add_normal_noise(s.points, {}, noise * edge, 7);
    const kernel::TriangleMesh mesh(s.points, s.faces);
    ridges::FitOptions options;
    options.errors = true;
    options.min_points = ridges::choose_support(mesh, {}).points;
    const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
    CAPTURE(noise);
    ridges::RidgeGraph g = ridges::extract_ridge_graph(mesh, fit.forms);
    CHECK(g.umbilics.size() == 4);
    CHECK(g.twice_index_sum == 4);
    const ridges::SalienceReport report = ridges::mark_salience(mesh, fit, g);
    CHECK(std::count_if(report.regions.begin(), report.regions.end(),
                        [](const auto& region) { return region.is_umbilic(); }) == 4);
    ridges::FilterOptions salient;
    salient.min_level = 2;
    ridges::filter(g, salient);
    // -k2, the larger curvature, is largest along the ellipse through all four.
    const RidgeCounts n = count_ridges(g);
    CHECK(n.loops[0] + n.segments[0] == 0);
    CHECK(n.loops[1] == 1);
    CHECK(n.segments[1] == 0);
  }
}

TEST_CASE("the paper's umbilic method agrees on the clean surfaces") {
  const RidgeCase c = fitted_case("ellipsoid", {1, 1.5, 2}, 10000, true);
  const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
  const ridges::PaperUmbilics p = ridges::paper_umbilics(c.mesh, c.forms, g, 3);
  CHECK(p.candidates >= 4);
  CHECK(p.plus == 4);
  CHECK(p.minus == 0);
}
