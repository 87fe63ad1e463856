// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/salience.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <map>
#include <numbers>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/certificate.hpp"
#include "algorithms/ridges/curvature_lines.hpp"
#include "tests/ridges/ridge_cases.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;

namespace {

struct Marked {
  kernel::TriangleMesh mesh;
  ridges::FitResult fit;
  ridges::RidgeGraph graph;
  ridges::SalienceReport report;
};

Marked marked(const kernel::TriangleMesh& mesh, int points, const ridges::SalienceOptions& o = {}) {
  ridges::FitOptions options;
  options.errors = true;
  options.min_points = points;
  Marked m{mesh, ridges::fit_monge_forms(mesh, options), {}, {}};
  m.graph = ridges::extract_ridge_graph(mesh, m.fit.forms);
  m.report = ridges::mark_salience(mesh, m.fit, m.graph, o);
  return m;
}

/// noise: of the mean edge, along the normals.
kernel::TriangleMesh sampled(const std::string& name, const std::vector<double>& parameters,
                             int vertices, double noise = 0, std::uint64_t seed = 1) {
  sampling::SurfaceSample s = sampling::sample(name, parameters, vertices, true);
  const double edge = sampling::mean_edge_length(s.points, s.faces);
  if (noise > 0) sampling::add_normal_noise(s.points, sampling::normals(s), noise * edge, seed);
  return {s.points, s.faces};
}

int index_sum(const std::vector<ridges::UmbilicRegion>& regions) {
  int sum = 0;
  for (const ridges::UmbilicRegion& r : regions) sum += r.twice_index;
  return sum;
}

/// Everything that salience sets, in one list.
std::vector<double> marks(const ridges::RidgeGraph& graph) {
  std::vector<double> all;
  for (const ridges::Ridge& r : graph.ridges) {
    all.push_back(r.weight);
    for (const ridges::Crossing& c : r.crossings)
      for (const double x : {c.significance, c.crest_significance, c.prominence, 1.0 * c.level})
        all.push_back(x);
  }
  for (const ridges::Umbilic& u : graph.umbilics)
    all.push_back(u.level + 10 * u.region_twice_index);
  return all;
}

}  // namespace

TEST_CASE("salience: no ridge of an analytic sample is dropped without noise") {
  const std::vector<std::pair<std::string, std::vector<double>>> surfaces = {
      {"ellipsoid", {1, 1.5, 2}},
      {"ellipsoid", {1, 1.02, 1.04}},
      {"ellipsoid", {1, 2, 8}},
      {"blend", {}}};
  for (const auto& [name, parameters] : surfaces) {
    const Marked m = marked(sampled(name, parameters, name == "blend" ? 40000 : 10000), 30);
    CAPTURE(name, parameters);
    CHECK(m.report.length > 0);
    CHECK(m.report.length_significant == Approx(m.report.length).epsilon(1e-12));
    CHECK(m.report.insignificant + m.report.short_runs == 0);
    CHECK(m.report.significant == m.graph.ridges.size());
    CHECK(index_sum(m.report.regions) == m.graph.twice_index_sum);
  }
}

TEST_CASE("salience: surfaces without ridges have no salient line, with noise or without") {
  for (const char* name : {"sphere", "plane", "cylinder", "torus"})
    for (const double noise : {0.0, 0.01})
      for (const int points : {30, 68, 150}) {
        const Marked m = marked(sampled(name, {}, 4000, noise), points);
        CAPTURE(name, noise, points, m.report.length / m.graph.model_size);
        CHECK(m.report.salient == 0);
        CHECK(m.report.length_significant < 0.4 * m.graph.model_size);
        CHECK(index_sum(m.report.regions) == m.graph.twice_index_sum);
      }
}

TEST_CASE("salience: on a noisy sphere no umbilic is told from another") {
  for (const double noise : {0.0, 0.01}) {
    const Marked m = marked(sampled("sphere", {}, 4000, noise), 30);
    std::map<int, int> regions;
    for (const ridges::UmbilicRegion& r : m.report.regions) ++regions[r.twice_index];
    CAPTURE(noise, regions);
    CHECK(regions[4] == 1);
    CHECK(index_sum(m.report.regions) == 4);
  }
}

TEST_CASE("salience: the ellipsoid's umbilics and crest lines survive noise") {
  for (const double noise : {0.001, 0.01}) {
    const kernel::TriangleMesh mesh = sampled("ellipsoid", {1, 1.5, 2}, 10000, noise, 7);
    const ridges::SupportChoice choice = ridges::choose_support(mesh, {});
    const Marked m = marked(mesh, choice.points);
    CAPTURE(noise, choice.points);
    CHECK(choice.points >= 150);
    int umbilics = 0;
    for (const ridges::UmbilicRegion& r : m.report.regions) {
      umbilics += r.is_umbilic();
      CHECK((r.is_umbilic() || r.twice_index == 0));
    }
    CHECK(umbilics == 4);
    // The one crest line of the ellipsoid: the red loop through the tips of the long axis.
    ridges::RidgeGraph salient = m.graph;
    ridges::FilterOptions kept;
    kept.min_level = 2;
    ridges::filter(salient, kept);
    CHECK(!salient.ridges.empty());
    for (const ridges::Ridge& r : salient.ridges) CHECK(r.colour == ridges::Colour::red);
  }
}

TEST_CASE("salience: supports are chosen by what stands out, 30 points where nothing does") {
  const ridges::SupportChoice clean =
      ridges::choose_support(sampled("ellipsoid", {1, 1.5, 2}, 4000), {});
  CHECK(clean.points == 30);
  CHECK(clean.trials.front().points == 30);
  CHECK(clean.trials.front().j > 0);
  // With 230 points alone the cylinder of 3000 vertices shows a line.
  for (const auto& [name, vertices] : {std::pair("sphere", 1000), {"cylinder", 3000}}) {
    const ridges::SupportChoice none = ridges::choose_support(sampled(name, {}, vertices), {});
    CHECK(none.points == 30);
  }
}

TEST_CASE("salience: it depends on no frame's sign and on no number of threads") {
  const kernel::TriangleMesh mesh = sampled("blend", {}, 6000, 0.01);
  const Marked m = marked(mesh, 45);
  Draw d(31);
  ridges::FitResult flipped = m.fit;
  for (auto& form : flipped.forms)
    if (d.coin()) reverse_frame(form);
  ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, flipped.forms);
  ridges::mark_salience(mesh, flipped, graph);
  CHECK(marks(graph) == marks(m.graph));
  for (const std::size_t threads : {1u, 3u}) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(marks(marked(mesh, 45).graph) == marks(m.graph));
  }
}

TEST_CASE("salience: it changes nothing that a certificate states, and its counts add up") {
  const kernel::TriangleMesh mesh = sampled("blend", {}, 6000, 0.02);
  const Marked m = marked(mesh, 30);
  const auto plain = ridges::extract_ridge_graph(mesh, m.fit.forms);
  CHECK(certify::encode(ridges::make_certificate(mesh, m.fit.forms, m.graph)) ==
        certify::encode(ridges::make_certificate(mesh, m.fit.forms, plain)));
  const ridges::SalienceReport& r = m.report;
  CHECK(r.insignificant > 0);
  CHECK(r.insignificant + r.short_runs + r.significant == m.graph.ridges.size());
  CHECK(r.not_crest + r.light + r.salient == r.significant);
  CHECK(r.length_salient <= r.length_significant);
  CHECK(r.length_significant <= r.length);
  CHECK(index_sum(r.regions) == m.graph.twice_index_sum);
  for (const int level : {1, 2}) {
    ridges::RidgeGraph kept = m.graph;
    ridges::FilterOptions filter;
    filter.min_level = level;
    const auto report = ridges::filter(kept, filter);
    CHECK(report.by_level == m.graph.ridges.size() - (level == 1 ? r.significant : r.salient));
    std::map<std::pair<Index, int>, int> crossings;
    for (const ridges::Ridge& ridge : m.graph.ridges)
      for (const auto& c : ridge.crossings) ++crossings[{c.edge, static_cast<int>(ridge.colour)}];
    double length = 0;
    for (const ridges::Ridge& ridge : kept.ridges) {
      for (const auto& c : ridge.crossings) {
        CHECK(c.level >= level);
        CHECK(crossings[{c.edge, static_cast<int>(ridge.colour)}]-- == 1);
      }
      for (const ridges::RidgeEnd& end : ridge.ends)
        CHECK((ridge.loop || end.kind != ridges::EndKind::none));
      for (std::size_t i = 0; i < ridge.segment_count(); ++i)
        length += kernel::distance(ridge.crossings[i].point,
                                   ridge.crossings[(i + 1) % ridge.crossings.size()].point);
    }
    CHECK(length == Approx(level == 1 ? r.length_significant : r.length_salient));
  }
}

TEST_CASE("salience: thresholds keep less as they grow") {
  const kernel::TriangleMesh mesh = sampled("blend", {}, 6000, 0.01);
  double significant = 1e300, salient = 1e300;
  for (const double z : {1.0, 3.0, 6.0, 20.0}) {
    const Marked m = marked(mesh, 68, {z, 0});
    CHECK(m.report.length_significant <= significant);
    significant = m.report.length_significant;
  }
  for (const double weight : {0.0, 0.5, 2.0, 1e9}) {
    const Marked m = marked(mesh, 68, {4, weight});
    CHECK(m.report.length_salient <= salient);
    salient = m.report.length_salient;
  }
  CHECK(salient == 0);
}

TEST_CASE("curvature lines: on a torus they are its circles") {
  // Not rotated: a circle of the tube lies in a plane through the axis z, one of latitude in z = c.
  const sampling::SurfaceSample s = sampling::sample("torus", {}, 8000, false);
  const kernel::TriangleMesh mesh(s.points, s.faces);
  const ridges::CurvatureLines lines(mesh, s.forms);
  const double edge = sampling::mean_edge_length(s.points, s.faces);
  for (const ridges::Colour colour : {ridges::Colour::blue, ridges::Colour::red}) {
    double worst = 0;
    std::size_t walks = 0;
    for (Index e = 5; e < mesh.edge_count(); e += 501)
      for (const bool forward : {true, false}) {
        ridges::LineWalk walk(lines, e, 0.3, colour, forward, edge);
        const auto at = [&](Index p, Index q, double w, std::size_t k) {
          return (1 - w) * mesh.points()[p][k] + w * mesh.points()[q][k];
        };
        // Height over the plane z = 0 and angle about the axis: one of the two stays.
        const kernel::Edge& start = mesh.edges()[e];
        const double z = at(start.v0, start.v1, 0.3, 2);
        const double angle =
            std::atan2(at(start.v0, start.v1, 0.3, 1), at(start.v0, start.v1, 0.3, 0));
        while (walk.length() < 12 * edge && walk.step()) {
          const Index p = walk.vertex(0), q = walk.vertex(1);
          const double x = at(p, q, walk.weight(), 0), y = at(p, q, walk.weight(), 1);
          const double turn = std::remainder(std::atan2(y, x) - angle, 2 * std::numbers::pi);
          const double off = std::min(std::fabs(at(p, q, walk.weight(), 2) - z),
                                      std::fabs(turn) * std::hypot(x, y));
          worst = std::max(worst, off / edge);
        }
        CHECK(walk.length() >= 12 * edge);
        ++walks;
      }
    CHECK(walks > 50);
    CHECK(worst < 0.5);
  }
}
