// SPDX-License-Identifier: GPL-3.0-or-later
// First zeros of rays: against closed formulas, through all that is degenerate, and against the
// checker of their certificates.
#include "algorithms/splines/rays.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "algorithms/splines/pinhole.hpp"
#include "algorithms/splines/quadratic_certificate.hpp"
#include "certify/verify.hpp"
#include "kernel/predicates/segment_zero.hpp"
#include "tests/splines/volumes.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/failures.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::dot;
using kernel::operator*;
using kernel::operator+;
using kernel::operator-;
using splines::Hit;
using splines::QuadraticSpline;
using splines::Ray;
using splines::RayCaster;
using splines::RayCounts;

namespace {

/// The rays' hits; their certificate must be accepted.
std::vector<Hit> certified(const QuadraticSpline& spline, double c, const std::vector<Ray>& rays,
                           RayCounts* counts = nullptr) {
  std::vector<Hit> hits(rays.size());
  const RayCounts n = RayCaster(spline, c).cast(rays, hits);
  if (counts) *counts = n;
  const auto verdict =
      certify::verify(certify::encode(splines::rays_certificate(spline, c, rays, hits)));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  for (const Hit& h : hits) {
    if (!h.hit) continue;
    double widest = h.t_lo;
    for (int i = 0; i < 4; ++i) widest = std::nextafter(widest, HUGE_VAL);
    CHECK((h.t_lo <= h.t && h.t <= h.t_hi && h.t_hi <= widest));
  }
  return hits;
}

/// The parameter at which a ray meets a sphere first.
std::optional<double> on_sphere(const Ray& ray, const Vec3& middle, double radius) {
  const Vec3 o = ray.origin - middle;
  const double a = dot(ray.direction, ray.direction), b = dot(o, ray.direction),
               c = dot(o, o) - radius * radius, d = b * b - a * c;
  if (d < 0) return std::nullopt;
  const double near = (-b - std::sqrt(d)) / a, far = (-b + std::sqrt(d)) / a;
  if (near >= 0) return near;
  return far >= 0 ? std::optional(far) : std::nullopt;
}

Vec3 direction(Draw& d) {
  Vec3 v;
  do
    for (double& x : v) x = d.uniform();
  while (dot(v, v) < 0.01);
  return v;
}

constexpr int kSide = 24;
const Vec3 kMiddle = {11.5, 11.5, 11.5};

}  // namespace

TEST_CASE("rule segment_zero: touching, both ends negative, reversed, parts") {
  using kernel::exact_segment_zero;
  CHECK(exact_segment_zero(-1, 2, -1));
  CHECK(exact_segment_zero(1, -1, 1));
  CHECK(exact_segment_zero(-1, 1, -1));
  CHECK_FALSE(exact_segment_zero(1, 0, 1));
  CHECK_FALSE(exact_segment_zero(-4, 3, -4));
  CHECK(exact_segment_zero(0, 1, 1));
  CHECK(exact_segment_zero(0, 0, 0));
  Draw d(kSeed);
  Failures failures;
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    const double b0 = d.integer(-9, 9), b1 = d.integer(-9, 9), b2 = d.integer(-9, 9);
    const bool zero = exact_segment_zero(b0, b1, b2);
    failures.expect(zero == exact_segment_zero(b2, b1, b0), "reversed", b0, b1, b2);
    failures.expect(zero == exact_segment_zero(-b0, -b1, -b2), "all signs", b0, b1, b2);
    // By halves, in integers.
    const double c1 = 2 * (b0 + b1), c2 = b0 + 2 * b1 + b2, c3 = 2 * (b1 + b2);
    failures.expect(
        zero == (exact_segment_zero(4 * b0, c1, c2) || exact_segment_zero(c2, c3, 4 * b2)),
        "halves", b0, b1, b2);
    const auto quick = kernel::triage_segment_zero(b0, b1, b2, 0x1p-40);
    failures.expect(!quick || *quick == zero, "triage", b0, b1, b2);
    failures.expect(!kernel::triage_segment_zero(b0, b1, b2, 10), "slack", b0, b1, b2);
  }
  CHECK(failures.report() == "");
  CHECK_FALSE(kernel::triage_segment_zero(NAN, 1, 1, 1e-9));
  CHECK_FALSE(kernel::triage_segment_zero(1, HUGE_VAL, 1, 1e-9));
}

TEST_CASE("random rays meet a sphere where the formula says, and none is missed") {
  const QuadraticSpline spline(sphere_volume(kSide));
  const double radius = 8.25;
  const RayCaster caster(spline, sphere_level(radius));
  Draw d(kSeed + 1);
  RayCounts counts;
  Failures failures;
  const std::uint64_t all = scaled(200000);
  for (std::uint64_t i = 0; i < all; ++i) {
    const Vec3 v = direction(d);
    const Vec3 target = kMiddle + 9.0 * Vec3{d.uniform(), d.uniform(), d.uniform()};
    const Ray ray = {target - (20 / std::sqrt(dot(v, v))) * v, v};
    const Hit hit = caster.cast(ray, counts);
    const auto t = on_sphere(ray, kMiddle, radius);
    failures.expect(hit.hit == t.has_value(), "hit", ray.origin, v);
    if (!hit.hit || !t) continue;
    failures.expect(std::fabs(hit.t - *t) <= 1e-10 * *t, "where", ray.origin, v, hit.t, *t);
    const Vec3 gradient = 8.0 * (hit.place - kMiddle) - hit.gradient;
    failures.expect(dot(gradient, gradient) < 1e-20, "gradient", ray.origin, v);
  }
  CHECK(failures.report() == "");
  CHECK(counts.cast == all);
  CHECK(counts.hits > all / 3);
  CHECK(counts.climbed < all / 200);
}

TEST_CASE("rays along axes, diagonals, in planes and through all kinds of vertices are certified") {
  const QuadraticSpline spline(sphere_volume(12));
  const Vec3 middle = {5.5, 5.5, 5.5};
  std::vector<Ray> rays;
  const std::vector<Vec3> directions = {{0, 0, 1},  {1, 0, 0},     {0, -1, 0}, {1, 1, 0},
                                        {1, 0, -1}, {1, 1, 1},     {-1, 1, 1}, {2, 1, 0},
                                        {1, 2, 3},  {0.5, 0, 0.25}};
  // Corners, centres, middles of faces and edges, and quarters.
  for (const double x : {2.5, 3.0, 4.0, 4.25})
    for (const double y : {2.5, 3.0, 5.5})
      for (const double z : {3.5, 5.0})
        for (const Vec3& v : directions) rays.push_back({Vec3{x, y, z} - 16.0 * v, v});
  RayCounts counts;
  const double radius = 3.25;
  const auto hits = certified(spline, sphere_level(radius), rays, &counts);
  Failures failures;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto t = on_sphere(rays[i], middle, radius);
    failures.expect(hits[i].hit == t.has_value(), "hit", rays[i].origin, rays[i].direction);
    if (hits[i].hit && t)
      failures.expect(std::fabs(hits[i].t - *t) < 1e-10, "where", rays[i].origin, hits[i].t, *t);
  }
  CHECK(failures.report() == "");
  CHECK(counts.climbed > 0);
}

TEST_CASE(
    "a touching ray is a hit, one a 2^-40 beside it is not, one nearer is no longer tangent") {
  const QuadraticSpline spline(sphere_volume(kSide));
  for (const Vec3& v : {Vec3{0, 0, 1}, Vec3{0, 0.5, 0}}) {
    const Vec3 start = Vec3{11.5 + 8, 11.5, 11.5} - 14.0 * v;
    const auto beside = [&](double x) { return Ray{start + Vec3{x, 0, 0}, v}; };
    const auto hits =
        certified(spline, sphere_level(8), {beside(-0x1p-40), beside(0), beside(0x1p-40)});
    CHECK(hits[0].hit);
    CHECK_FALSE(hits[0].tangent);
    CHECK(hits[1].hit);
    CHECK(hits[1].tangent);
    CHECK(hits[1].t_lo == 14);
    CHECK(hits[1].t_hi == 14);
    CHECK_FALSE(hits[2].hit);
  }
}

TEST_CASE("rays that start inside, at the surface, behind it, or meet the domain in a point") {
  const QuadraticSpline spline(sphere_volume(12));
  const Vec3 middle = {5.5, 5.5, 5.5};
  // The domain is [0.5, 10.5]^3; its corner (10.5, 10.5, 10.5) has s = 4 * 75 + 3.
  const auto hits = certified(spline, sphere_level(3),
                              {{middle, {1, 0, 0}},
                               {middle + Vec3{3, 0, 0}, {1, 0, 0}},
                               {middle + Vec3{3.125, 0, 0}, {1, 0, 0}},
                               {middle + Vec3{3, 0, 0}, {-0.5, 0, 0}},
                               {{20, 20, 20}, {1, 1, 1}},
                               {{20, 0, 0}, {0, 1, 0}}});
  CHECK(hits[0].t == 3);
  CHECK(hits[1].t == 0);
  CHECK(hits[1].t_lo == 0);
  CHECK_FALSE(hits[2].hit);
  CHECK(hits[3].t == 0);
  CHECK_FALSE(hits[4].hit);
  CHECK_FALSE(hits[5].hit);
  const Ray corner = {{11.5, 9.5, 10.5}, {-1, 1, 0}};
  CHECK(certified(spline, 303, {corner})[0].hit);
  CHECK(certified(spline, 303, {corner})[0].t == 1);
  CHECK_FALSE(certified(spline, 302, {corner})[0].hit);
}

TEST_CASE("integer data with c equal to samples, and rays over a plateau at c") {
  auto grid = random_volume<std::uint8_t>({7, 6, 8}, 1, kSeed + 3);
  for (auto& x : std::get<std::vector<std::uint8_t>>(grid.samples)) x &= 3;
  std::vector<Ray> rays;
  Draw d(kSeed + 4);
  for (int i = 0; i < 60; ++i) {
    const Vec3 v = i % 2 ? direction(d) : Vec3{1.0 * (i % 3), 1, 0.5 * (i % 5)};
    rays.push_back({Vec3{3, 3, 3} - 9.0 * v, v});
  }
  RayCounts counts;
  for (const double c : {0.0, 1.0, 2.0}) certified(QuadraticSpline(grid), c, rays, &counts);
  grid.samples = std::vector<std::uint8_t>(grid.count(), 5);
  for (const Hit& h : certified(QuadraticSpline(grid), 5, rays, &counts))
    if (h.hit) CHECK(h.gradient == Vec3{});
  CHECK(counts.hits > 30);
  CHECK(counts.tangent == counts.hits);
}

TEST_CASE("random volumes in turned frames, extended ones, wide exponents: certificates hold") {
  Draw d(kSeed + 5);
  auto grid = random_volume<float>({6, 7, 5}, 100, kSeed + 6);
  auto& samples = std::get<std::vector<float>>(grid.samples);
  grid.spacing = {0.5, 0.3, 1.7};
  grid.origin = {100, -3, 1e-3};
  grid.directions = {{{0.48, 0.6, 0.64}, {-0.8, 0.6, 0}, {0.384, 0.512, -0.768}}};
  const auto rays_from = [&](double far) {
    std::vector<Ray> rays;
    for (int i = 0; i < 100; ++i) {
      const Vec3 v = direction(d);
      const Vec3 target =
          grid.to_world({0.5 * (2.5 + d.uniform()), 0.3 * (3 + d.uniform()), 1.7 * 2});
      rays.push_back({target - far * v, v});
    }
    return rays;
  };
  for (const splines::Border border : {splines::Border::none, splines::Border::extend}) {
    RayCounts counts;
    certified(QuadraticSpline(grid, border), 3.3, rays_from(10), &counts);
    CHECK(counts.hits > 50);
    certified(QuadraticSpline(grid, border), 3.3, rays_from(1e9), &counts);
    CHECK(counts.hits > 50);
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] *= std::ldexp(1.0F, static_cast<int>(i % 60) - 100);
  const QuadraticSpline wide(grid);
  CHECK_FALSE(wide.exact());
  certified(wide, 0, rays_from(10));
  certified(wide, 1e-30, rays_from(10));
  for (float& x : samples) x *= 0x1p120F;
  certified(QuadraticSpline(grid), 1e12, rays_from(10));
}

TEST_CASE("data and rays at the ends of the range of doubles") {
  auto grid = random_volume<double>({5, 5, 5}, 100, kSeed + 8);
  auto& samples = std::get<std::vector<double>>(grid.samples);
  const std::vector<Ray> rays = {{{2, 2, -9}, {0, 0, 1e-300}},
                                 {{2, 2.25, -9}, {1e-320, 0, 1}},
                                 {{2, 2, -1e18}, {0, 0, 1e300}}};
  certified(QuadraticSpline(grid), 1, rays);
  for (double& x : samples) x *= 0x1p1015;
  certified(QuadraticSpline(grid), 0, rays);
  for (double& x : samples) x = std::ldexp(x, -2060);
  certified(QuadraticSpline(grid), 0, rays);
}

TEST_CASE("samples times a power of two, up to the ends of doubles, have the same hits") {
  const auto scaled = [](double scale) {
    auto grid = random_volume<double>({8, 8, 8}, 9, kSeed + 8);
    for (double& x : std::get<std::vector<double>>(grid.samples)) x *= scale;
    return QuadraticSpline(grid);
  };
  std::vector<Ray> rays;
  for (int i = 0; i < 49; ++i)
    rays.push_back({{0.5 + i % 7, 0.75 + i / 7, -2}, {0.0625 * (i % 5), 0.125, 1}});
  const auto one = certified(scaled(1), 0.3125, rays);
  for (const int power : {-1067, -1020, -900, -530, -140, -110, 120, 500, 1000}) {
    INFO(power);
    const double scale = std::ldexp(1.0, power);
    const auto other = certified(scaled(scale), 0.3125 * scale, rays);
    int hits = 0, different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits += one[i].hit;
      different += other[i].hit != one[i].hit || other[i].cube != one[i].cube ||
                   other[i].tetrahedron != one[i].tetrahedron || other[i].t_lo > one[i].t_hi ||
                   other[i].t_hi < one[i].t_lo;
    }
    CHECK(hits > 20);
    CHECK(different == 0);
  }
}

TEST_CASE("a camera's rays: the same for any number of threads") {
  const QuadraticSpline spline(volume_of<float>(
      20, [](double x, double y, double z) { return x * x + std::sin(3 * y) + z * z * z; }));
  const auto camera = splines::automatic_view(spline, 64);
  const auto rays = camera.rays();
  CHECK(rays.size() == 64 * 64);
  std::vector<std::vector<Hit>> hits;
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    hits.push_back(certified(spline, 0.25, rays));
  }
  std::size_t differ = 0, count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit &a = hits[0][i], &b = hits[1][i];
    count += a.hit;
    differ += a.hit != b.hit || a.t_lo != b.t_lo || a.t_hi != b.t_hi || a.place != b.place ||
              a.gradient != b.gradient || a.cube != b.cube || a.tetrahedron != b.tetrahedron;
  }
  CHECK(differ == 0);
  CHECK(count > 500);
}
