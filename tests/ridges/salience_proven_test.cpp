// SPDX-License-Identifier: GPL-3.0-or-later
// What salience drops of a noise-free surface, against the surface's proven graph.
#include <algorithm>
#include <catch2/catch.hpp>

#include "algorithms/ridges/salience.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "algorithms/smooth_ridges/surface.hpp"
#include "kernel/arithmetic/self_test.hpp"

using namespace crest;

namespace {

double length_of(const std::vector<kernel::Vec3>& points, bool loop) {
  double sum = loop ? kernel::distance(points.back(), points.front()) : 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += kernel::distance(points[i], points[i + 1]);
  return sum;
}

double shortest_proven_line() {
  // The sample's "perturbed-torus" with its default parameters.
  const auto proven = smooth_ridges::smooth_ridges(
      smooth_ridges::Surface::implicit(
          "(sqrt(x^2+y^2)-1)^2+0.16*((z/0.8)^2-0.3*(0.6*x*y+0.4*x*(z/0.8)+0.3*y-0.25*y*(z/0.8)"
          "+0.2*x^2*(z/0.8))-1)",
          {-2, 2, -2, 2, -2, 2}),
      {});
  REQUIRE(proven.certified);
  double shortest = 1e300;
  for (const auto& r : proven.ridges) shortest = std::min(shortest, length_of(r.points, r.loop));
  return shortest;
}

}  // namespace

TEST_CASE("salience: no ridge of the perturbed torus that is dropped whole is a real one") {
  kernel::require_sound_floating_point();
  const double shortest = shortest_proven_line();
  const sampling::SurfaceSample s = sampling::sample("perturbed-torus", {}, 20000, false);
  const kernel::TriangleMesh mesh(s.points, s.faces);
  ridges::FitOptions options;
  options.errors = true;
  const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
  ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, fit.forms);
  const ridges::SalienceReport report = ridges::mark_salience(mesh, fit, graph);
  CHECK(report.length_significant > 0.9 * report.length);
  int dropped = 0;
  for (const ridges::Ridge& r : graph.ridges) {
    if (std::any_of(r.crossings.begin(), r.crossings.end(),
                    [](const ridges::Crossing& c) { return c.level > 0; }))
      continue;
    ++dropped;
    CHECK(r.length < shortest);
  }
  CHECK(dropped > 0);
}
