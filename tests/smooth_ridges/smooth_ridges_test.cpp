// SPDX-License-Identifier: GPL-3.0-or-later
// Certified ridges from start to verdict, and refusals.
#include "algorithms/smooth_ridges/smooth_ridges.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "certify/ridges_smooth/encode.hpp"
#include "certify/verify.hpp"

namespace crest::smooth_ridges {
namespace {

struct Counts {
  int plus = 0, minus = 0;
  std::array<int, 4> ridges{};  ///< blue loops, blue paths, red loops, red paths
};
Counts counts(const SmoothRidges& r) {
  Counts c;
  for (const UmbilicPoint& u : r.umbilics) ++(u.twice_index > 0 ? c.plus : c.minus);
  for (const SmoothRidge& ridge : r.ridges)
    ++c.ridges[2 * static_cast<std::size_t>(ridge.colour) + (ridge.loop ? 0 : 1)];
  return c;
}
Options small() {
  Options o;
  o.start_faces = 600;
  o.refinement.max_faces = 60000;
  return o;
}

TEST_CASE("An ellipsoid: four umbilics, one loop and two paths a colour, accepted by the checker") {
  const auto surface = Surface::implicit("x^2 + y^2/2.25 + z^2/4 - 1", {-3, 3, -3, 3, -3, 3});
  const SmoothRidges r = smooth_ridges(surface, small());
  REQUIRE(r.certified);
  CHECK(r.euler_characteristic == 2);
  const Counts c = counts(r);
  CHECK(c.plus == 4);
  CHECK(c.minus == 0);
  CHECK(c.ridges == std::array{1, 2, 1, 2});
  CHECK(r.turning_points.empty());
  CHECK(r.purple_points.size() == 6);
  for (const UmbilicPoint& u : r.umbilics) {
    CHECK(u.branches == std::array{1, 1});
    // a^2 (a^2 - b^2) / (a^2 - c^2) with a = 1, b = 1.5, c = 2.
    CHECK(u.point[0] * u.point[0] == Approx(1.25 / 3).epsilon(1e-9));
    CHECK(std::fabs(u.point[1]) < 1e-9);
  }
  const certify::Bytes bytes = certify::encode(r.certificate);
  CHECK(certify::verify(bytes).accepted);

  SECTION("the same bytes for one thread") {
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(certify::encode(smooth_ridges(surface, small()).certificate) == bytes);
  }
  SECTION("a count that is not true is rejected") {
    auto lie = r.certificate;
    ++lie.purple_points;
    CHECK_FALSE(certify::verify(certify::encode(lie)).accepted);
  }
}

TEST_CASE("A ridge through a corner of the domain is certified") {
  // E2 vanishes exactly at (0, 0) by symmetry, as on the patch of Cazals and others (2006).
  const auto surface = Surface::parametric({"u", "v", "u*v - u^2*v - u*v^2 + 0.7*u^3*v"},
                                           {"0", "0.2", "0", "0.2"}, {false, false});
  const SmoothRidges r = smooth_ridges(surface, small());
  REQUIRE(r.certified);
  CHECK(certify::verify(certify::encode(r.certificate)).accepted);
}

TEST_CASE("What is not generic is refused") {
  Options o = small();
  o.start_faces = 200;
  SECTION("sphere") {
    const SmoothRidges r =
        smooth_ridges(Surface::implicit("x^2 + y^2 + z^2 - 1", {-2, 2, -2, 2, -2, 2}), o);
    CHECK_FALSE(r.certified);
    CHECK_FALSE(r.undecided.empty());
  }
  SECTION("torus of revolution") {
    const SmoothRidges r =
        smooth_ridges(Surface::parametric({"(2 + cos(v))*cos(u)", "(2 + cos(v))*sin(u)", "sin(v)"},
                                          {"0", "2*pi", "0", "2*pi"}, {true, true}),
                      o);
    CHECK_FALSE(r.certified);
    CHECK_FALSE(r.undecided.empty());
  }
  SECTION("cylinder in a box, cone") {
    for (const char* f : {"x^2 + y^2 - 1", "x^2 + y^2 - z^2"}) {
      const SmoothRidges r = smooth_ridges(Surface::implicit(f, {-2, 2, -2, 2, -2, 2}), o);
      CHECK_FALSE(r.certified);
      CHECK_FALSE(r.obstacles.empty());
    }
  }
}

}  // namespace
}  // namespace crest::smooth_ridges
