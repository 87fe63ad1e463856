// SPDX-License-Identifier: GPL-3.0-or-later
// within and enclosed_volume: laws, stages, ties that no double decides.
#include <catch2/catch.hpp>

#include "kernel/predicates/enclosed_volume.hpp"
#include "kernel/predicates/within.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

const std::vector<FaceCorners> kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::vector<FaceCorners> turned(std::vector<FaceCorners> faces) {
  for (auto& face : faces) std::swap(face[1], face[2]);
  return faces;
}

}  // namespace

TEST_CASE("within: laws, ties and every stage") {
  require_depth(WithinDistance{{1, 2, 3}, {4, 5, 6}, 1});
  CHECK(within({0, 0, 0}, {3, 4, 0}, 5));
  CHECK_FALSE(within({0, 0, 0}, {3, 4, 0}, std::nextafter(5, 0)));
  CHECK_FALSE(within({0, 0, 0}, {3, 4, 1e-200}, 5));  // the square underflows
  CHECK(within({1e300, 0, 0}, {1e300, 0, 0}, 0));     // law 2
  CHECK_FALSE(within({1e300, 0, 0}, {-1e300, 0, 0}, 1e300));
  CHECK(within({0, -0.0, 0}, {-0.0, 0, 0}, 0));
  for (const Family family : kFamilies) {
    Draw d(900, family);
    const auto make = [&](std::uint64_t i) {
      const Vec3 p = draw_vector(d, family), q = i % 4 == 0 ? p : draw_vector(d, family);
      return WithinDistance{p, q, std::fabs(draw(d, family))};
    };
    require_stages_agree<WithinDistance>(500, make);
    require_bound(200, [&] { return make(1); });
    for (std::uint64_t i = 0; i < 200; ++i) {
      const WithinDistance f = make(i);
      CHECK(within(f.p, f.q, f.t) == within(f.q, f.p, f.t));        // law 1
      CHECK(within(f.p, f.q, 0) == (f.p == f.q));                   // law 3
      if (within(f.p, f.q, f.t)) CHECK(within(f.p, f.q, 2 * f.t));  // law 4
    }
  }
}

TEST_CASE("enclosed volume: laws and every stage") {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(enclosed_volume(points, kTetrahedron) == Sign::positive);          // law 3
  CHECK(enclosed_volume(points, turned(kTetrahedron)) == Sign::negative);  // law 1
  CHECK(enclosed_volume_decision(points, kTetrahedron).stage == Stage::triage);
  CHECK(enclosed_volume(points, {}) == Sign::zero);
  std::vector<FaceCorners> both = kTetrahedron;
  for (const auto& face : turned(kTetrahedron)) both.push_back(face);
  const Decision zero = enclosed_volume_decision(points, both);  // without a rounding
  CHECK(zero.sign == Sign::zero);                                // law 4
  CHECK(zero.stage == Stage::interval);
  const std::vector<Vec3> rounded = {{0.1, 0.2, 0.7}, {1.3, 0, 0.1}, {0, 1.1, 0.3}, {0.9, 0.1, 1}};
  const Decision undecided = enclosed_volume_decision(rounded, both);
  CHECK(undecided.sign == Sign::zero);
  CHECK(undecided.stage == Stage::exact);
  // Flat but for the last bit, far from the origin.
  std::vector<Vec3> flat = {{1e6, 1e6, 1e6}, {1e6 + 1, 1e6, 1e6}, {1e6, 1e6 + 1, 1e6}};
  flat.push_back({1e6 + 0.25, 1e6 + 0.25, std::nextafter(1e6, 2e6)});
  CHECK(enclosed_volume(flat, kTetrahedron) == Sign::positive);
  flat[3][2] = 1e6;
  CHECK(enclosed_volume(flat, kTetrahedron) == Sign::zero);
  for (const Family family : kFamilies) {
    Draw d(910, family);
    for (int i = 0; i < 200; ++i) {
      std::vector<Vec3> p;
      for (int v = 0; v < 4; ++v) p.push_back(draw_vector(d, family));
      using R = Rational;
      const auto o = lift<R>(p[0]);
      const R volume = determinant(lift<R>(p[1]) - o, lift<R>(p[2]) - o, lift<R>(p[3]) - o);
      CHECK(enclosed_volume(p, kTetrahedron) == sign_of(volume));
      CHECK(enclosed_volume(p, turned(kTetrahedron)) == -sign_of(volume));
    }
  }
}
