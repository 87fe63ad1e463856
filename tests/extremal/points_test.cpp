// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of points whose normals have random signs.
#include <catch2/catch.hpp>

#include "algorithms/extremal/direction.hpp"
#include "algorithms/extremal/extremal.hpp"
#include "algorithms/extremal/point_field.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest;
using namespace crest::tests;
using extremal::OrientedPoints;
using extremal::Result;

namespace {

double unit(Draw& d) {
  return 0.5 * (d.uniform() + 1);
}
void add(OrientedPoints& p, Draw& d, const Vec3& x, const Vec3& n) {
  p.points.push_back(x);
  p.normals.push_back(d.coin() ? n : kernel::operator*(-1.0, n));
}

/// ((1 + w cos(u/2)) cos u, (1 + w cos(u/2)) sin u, w sin(u/2)), |w| <= 0.45.
OrientedPoints moebius_strip(int count) {
  OrientedPoints p;
  Draw d(1);
  for (int i = 0; i < count; ++i) {
    const double u = 2 * M_PI * unit(d), w = 0.45 * d.uniform();
    const double r = 1 + w * std::cos(u / 2);
    const Vec3 across = {std::cos(u / 2) * std::cos(u), std::cos(u / 2) * std::sin(u),
                         std::sin(u / 2)};
    const Vec3 along = {-r * std::sin(u) - w / 2 * std::sin(u / 2) * std::cos(u),
                        r * std::cos(u) - w / 2 * std::sin(u / 2) * std::sin(u),
                        w / 2 * std::cos(u / 2)};
    add(p, d, {r * std::cos(u), r * std::sin(u), w * std::sin(u / 2)},
        kernel::cross(across, along));
  }
  return p;
}

OrientedPoints sphere(int count, bool half) {
  OrientedPoints p;
  Draw d(2);
  for (int i = 0; i < count; ++i) {
    const double z = half ? unit(d) : d.uniform(), a = 2 * M_PI * unit(d), r = std::sqrt(1 - z * z);
    const Vec3 x = {r * std::cos(a), r * std::sin(a), z};
    add(p, d, x, x);
  }
  return p;
}

extremal::PointOptions options(double radius, int depth) {
  extremal::PointOptions o;
  o.radius = radius;
  o.depth = depth;
  return o;
}

}  // namespace

TEST_CASE("extremal points: a Moebius strip has one rim and one side") {
  const Result r = extremal::extract(moebius_strip(6000), options(0.12, 6));
  REQUIRE(r.components.size() == 1);
  const auto& c = r.components[0];
  CHECK(c.euler_characteristic == 0);
  CHECK(c.boundary_loops == 1);
  CHECK(!c.orientable);
  CHECK(r.counts.odd_faces == 0);
  CHECK(r.counts.undecided_edges == 0);
  CHECK(r.counts.valence[2] + r.counts.valence[3] == 0);
  double length = 0, width = 0, rim = 0;
  for (const auto& f : r.features) {
    CHECK(f.reason == extremal::Reason::trim);
    const Vec3 &a = r.points[f.a], &b = r.points[f.b];
    length += kernel::distance(a, b);
    width += std::hypot(std::hypot(a[0], a[1]) - 1, a[2]);
    ++rim;
  }
  CHECK(length == Approx(12.92).margin(0.1));
  CHECK(width / rim == Approx(0.45).margin(0.02));
}

TEST_CASE("extremal points: a sphere is closed, half of it a disc") {
  const Result whole = extremal::extract(sphere(3000, false), options(0.25, 6));
  REQUIRE(whole.components.size() == 1);
  CHECK(whole.components[0].euler_characteristic == 2);
  CHECK(whole.components[0].boundary_loops == 0);
  CHECK(whole.features.empty());
  const Result half = extremal::extract(sphere(2000, true), options(0.25, 6));
  REQUIRE(half.components.size() == 1);
  CHECK(half.components[0].euler_characteristic == 1);
  CHECK(half.components[0].boundary_loops == 1);
}

TEST_CASE("extremal points: the rim of a half plane is where the points end") {
  OrientedPoints p;
  for (int i = -60; i <= 0; ++i)
    for (int k = -60; k <= 60; ++k) {
      p.points.push_back({0.02 * i, 0.02 * k, 0});
      p.normals.push_back({0, 0, (i + k) % 2 == 0 ? 1.0 : -1.0});
    }
  const double h = 0.2;
  const Result r = extremal::extract(p, options(h, 6));
  double worst = 0;
  std::size_t counted = 0;
  for (const auto& f : r.features) {
    const Vec3& x = r.points[f.a];
    if (x[0] < -0.5 || std::fabs(x[1]) > 0.5) continue;
    // The last row of points stands for half a step more.
    worst = std::max(worst, std::fabs(x[0] - 0.01));
    ++counted;
  }
  CHECK(counted > 10);
  CHECK(worst < 0.03 * h);
}

TEST_CASE("extremal points: what a box claims holds at its points") {
  const OrientedPoints p = moebius_strip(2000);
  const extremal::PointField field(p.points, p.normals, 0.2);
  Draw d(3);
  std::size_t passed = 0, empty = 0, failed = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3& at = p.points[static_cast<std::size_t>(d.integer(0, 1999))];
    const Vec3 centre = {at[0] + 0.1 * d.uniform(), at[1] + 0.1 * d.uniform(),
                         at[2] + 0.1 * d.uniform()};
    const double half = (i % 2 == 0 ? 0.02 : 0.08) * unit(d);
    const auto box = field.box(centre, {half, half, half});
    passed += box.passed ? 1 : 0;
    empty += box.nonzero ? 1 : 0;
    int sign = 0;
    for (int k = 0; k < 20 && box.passed; ++k) {
      const Vec3 x = {centre[0] + half * d.uniform(), centre[1] + half * d.uniform(),
                      centre[2] + half * d.uniform()};
      const auto local = field.at(x).local;
      const Vec3 n = extremal::dominant_direction(local.tensor);
      const double cosine = kernel::dot(n, box.w);
      failed += std::fabs(cosine) < std::cos(box.theta) - 1e-9 ? 1 : 0;
      const int g = kernel::dot(n, local.gradient) * cosine > 0 ? 1 : -1;
      failed += box.nonzero && sign * g < 0 ? 1 : 0;
      sign = g;
    }
  }
  CHECK(failed == 0);
  CHECK(passed > 100);
  CHECK(empty > 20);
}

TEST_CASE("extremal points: bad input is named, zero normals are dropped") {
  const auto message = [](const OrientedPoints& p, const extremal::PointOptions& o) -> std::string {
    try {
      extremal::extract(p, o);
    } catch (const kernel::InputError& e) {
      return e.what();
    }
    return "";
  };
  OrientedPoints p;
  CHECK(message(p, {}).find("no points") == 0);
  p.points = {{0, 0, 0}, {1, 0, 0}};
  CHECK(message(p, {}).find("points without normals") == 0);
  p.normals = {{0, 0, 0}, {0, 0, 0}};
  CHECK(message(p, {}).find("all normals are zero") == 0);
  p.normals = {{0, 0, 1}, {0, 0, 1}};
  CHECK(message(p, {}).find("fewer than 11 points") == 0);
  CHECK(message(p, options(-1, 5)).find("radius") == 0);
  for (const double radius : {0x1p-201, 0x1p201, 5e-324, 1e308})
    CHECK(message(p, options(radius, 5)).find("radius: not from 2^-200") == 0);
  CHECK(message(p, options(1, 25)).find("depth") == 0);
  p.points[1][2] = NAN;
  CHECK(message(p, {}).find("point 1") == 0);
  OrientedPoints s = sphere(2000, false);
  s.points.push_back(s.points[0]);
  s.normals.push_back({0, 0, 0});
  s.points.push_back(s.points[0]);  // Twice the same is kept.
  s.normals.push_back(s.normals[0]);
  const Result r = extremal::extract(s, options(0.3, 5));
  CHECK(r.counts.points_dropped == 1);
  CHECK(r.components[0].euler_characteristic == 2);
}
