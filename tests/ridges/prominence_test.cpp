// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/prominence.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace crest;

namespace {

constexpr double kStep = 0.125, kSigma = 0.01;

/// A plane patch whose k1 along x is 10 + height(x): one blue ridge at x = 0, half-way between two
/// columns of vertices, of the given sense (1: a maximum). R = 1.
struct Patch {
  kernel::TriangleMesh mesh;
  ridges::FitResult fit;
};

template <class Height>
Patch patch(const Height& height, int sense, double wide = 1) {
  constexpr unsigned kHalf = 40, kRows = 8;
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  ridges::FitResult fit;
  for (unsigned j = 0; j <= kRows; ++j)
    for (unsigned i = 0; i < 2 * kHalf; ++i) {
      const double x = (double(i) - kHalf + 0.5) * kStep, f = height(x);
      points.push_back({x, j * kStep, 0});
      kernel::MongeForm m{};
      m.d1 = {1, 0, 0};
      m.n = {0, 0, 1};
      m.k1 = 10 + f;
      m.k2 = -3;
      m.b0 = x < 0 ? sense : -sense;
      m.b3 = 1;
      m.c0 = 3 * m.k1 * m.k1 * m.k1 - sense;  // P1 has the sign of -sense
      fit.forms.push_back(m);
      ridges::CurvatureError e;
      e.k1 = e.k2 = e.gap = kSigma;
      e.wide_k1 = 10 + wide * f;
      e.wide_k2 = -3;
      e.radius = 1;
      fit.errors.push_back(e);
      const unsigned a = j * 2 * kHalf + i, b = a + 2 * kHalf;
      if (i + 1 == 2 * kHalf || j == kRows) continue;
      faces.push_back({a, a + 1, b + 1});
      faces.push_back({a, b + 1, b});
    }
  return {{std::move(points), std::move(faces)}, std::move(fit)};
}

/// A crossing in the middle of the ridge, marked.
ridges::Crossing marked(const Patch& p) {
  ridges::RidgeGraph graph = ridges::extract_ridge_graph(p.mesh, p.fit.forms);
  REQUIRE(graph.ridges.size() == 1);
  ridges::mark_prominence(p.mesh, p.fit, graph);
  const auto& all = graph.ridges[0].crossings;
  return all[all.size() / 2];
}

/// Falls by 1 to the left, by 2 to the right, within 1.
double hill(double x) {
  return x < 0 ? -std::fmin(-x, 1) : -2 * std::fmin(x, 1);
}

}  // namespace

TEST_CASE("prominence: the drop on the lesser side, from the peak within an edge") {
  // The peak is the column at -step / 2, a quarter of a step higher than the crossing.
  const double drop = 1 - kStep / 2;
  const ridges::Crossing c = marked(patch(hill, 1));
  CHECK(c.type == ridges::RidgeType::elliptic);
  CHECK(c.prominence == Approx(drop));
  CHECK(c.significance == Approx(drop / (kSigma * std::sqrt(2.0))));
  CHECK(c.crest_significance == c.significance);
}

TEST_CASE("prominence: a minimum stands out as a minimum, not as a crest") {
  const ridges::Crossing c = marked(patch([](double x) { return -hill(x); }, -1));
  CHECK(c.type == ridges::RidgeType::hyperbolic);
  CHECK(c.prominence == Approx(1 - kStep / 2));
  CHECK(c.significance > 50);
  CHECK(c.crest_significance == 0);
}

TEST_CASE("prominence: what the wider fit does not confirm is the model's error") {
  const double drop = 1 - kStep / 2;
  for (const double wide : {0.5, 0.0, -1.0}) {
    const double noise = 2 * kSigma * kSigma, model = (1 - wide) * drop;
    const ridges::Crossing c = marked(patch(hill, 1, wide));
    CHECK(c.prominence == Approx(drop));
    CHECK(c.significance == Approx(drop / std::sqrt(noise + (model * model - noise) / 4)));
    CHECK((wide > 0 ? c.significance > 4 * 0.9 : c.significance < 4));
  }
}

TEST_CASE("prominence: a difference that noise explains is no model's error") {
  const double drop = 1 - kStep / 2, explained = kSigma * std::sqrt(2.0) / drop;
  const double z = drop / (kSigma * std::sqrt(2.0));
  CHECK(marked(patch(hill, 1, 1 - 0.99 * explained)).significance == Approx(z));
  CHECK(marked(patch(hill, 1, 1 - 3 * explained)).significance == Approx(z / std::sqrt(3.0)));
}

TEST_CASE("prominence: a walk ends where k exceeds the peak, and at four times the radius") {
  // A higher hill to the right, beyond a valley 0.5 deep.
  const auto beside = [](double x) { return x < 0 ? hill(x) : x < 0.5 ? -x : x - 1; };
  CHECK(marked(patch(beside, 1)).prominence == Approx(0.5 - kStep).margin(kStep / 2));
  // An abyss farther away than 4 R does not count.
  const auto abyss = [](double x) {
    return std::fabs(x) > 4.3 ? -5.0 : -std::fmin(std::fabs(x), 1);
  };
  CHECK(marked(patch(abyss, 1)).prominence == Approx(1 - kStep / 2));
}
