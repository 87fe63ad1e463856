// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/creases.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "algorithms/ridges/salience.hpp"

using namespace crest;

namespace {

/// A strip of n x 2m squares of side 1, folded along its middle line by an angle that goes from
/// `degrees` to `last`.
kernel::TriangleMesh folded(unsigned n, unsigned m, double degrees, double last) {
  std::vector<kernel::Vec3> points;
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= 2 * m; ++j) {
      const double angle = (degrees + (last - degrees) * i / n) * std::numbers::pi / 180;
      const double y = double(j) - m, turn = j > m ? angle : 0;
      points.push_back({double(i), y * std::cos(turn), y * std::sin(turn)});
    }
  std::vector<kernel::Triangle> faces;
  const unsigned row = 2 * m + 1;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < 2 * m; ++j) {
      const unsigned a = i * row + j, b = a + row;
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
    }
  return {std::move(points), std::move(faces)};
}

kernel::TriangleMesh folded(unsigned n, unsigned m, double degrees) {
  return folded(n, m, degrees, degrees);
}

std::ptrdiff_t marked(const kernel::TriangleMesh& mesh) {
  const auto crease = ridges::crease_vertices(mesh);
  return std::count(crease.begin(), crease.end(), 1);
}

/// Of the salient lines beside the fold, from x to x.
double salient_along(const ridges::RidgeGraph& graph, double from, double to) {
  double length = 0;
  for (const ridges::Ridge& r : graph.ridges)
    for (std::size_t i = 0; i < r.segment_count(); ++i) {
      const auto &a = r.crossings[i], &b = r.crossings[(i + 1) % r.crossings.size()];
      if (a.level == 2 && b.level == 2 && std::fabs(a.point[1]) < 1.5 && a.point[0] >= from &&
          a.point[0] <= to)
        length += kernel::distance(a.point, b.point);
    }
  return length;
}

}  // namespace

TEST_CASE("creases: a fold of more than 40 degrees and at least 30 edges") {
  CHECK(marked(folded(30, 3, 41)) == 31);
  CHECK(marked(folded(30, 3, -41)) == 31);  // concave
  CHECK(marked(folded(30, 3, 39)) == 0);
  CHECK(marked(folded(29, 3, 41)) == 0);
}

TEST_CASE("creases: a fold is a salient line whatever the support and the weight asked for") {
  const kernel::TriangleMesh mesh = folded(40, 10, 60);
  for (const auto& [points, weight] : {std::pair(30, 1.5), {150, 1.5}, {30, 1e9}}) {
    ridges::FitOptions options;
    options.errors = true;
    options.min_points = points;
    const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
    CHECK(std::count(fit.creases.begin(), fit.creases.end(), 1) == 41);
    CHECK(fit.quality[20 * 21 + 10].points < 60);  // on the fold
    CHECK(fit.quality[20 * 21 + 1].points >= std::min(points, 100));
    ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, fit.forms);
    ridges::mark_salience(mesh, fit, graph, {4, weight});
    const double length = salient_along(graph, 0, 40);
    CAPTURE(points, weight, length);
    CHECK(length > 30);  // of 40
  }
}

TEST_CASE("creases: where a fold fades its sharp part is salient whatever the weight") {
  const kernel::TriangleMesh mesh = folded(120, 10, 70, 0);
  ridges::FitOptions options;
  options.errors = true;
  const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options);
  const auto sharp = std::count(fit.creases.begin(), fit.creases.end(), 1);
  CHECK(sharp > 40);
  CHECK(sharp < 60);
  ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, fit.forms);
  ridges::mark_salience(mesh, fit, graph, {4, 1e9});
  CHECK(salient_along(graph, 0, 50) > 40);
  CHECK(salient_along(graph, 55, 120) == 0);
}
