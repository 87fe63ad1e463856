// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes with one sheet and points with normals of any sign.
#include "algorithms/sampling/phantoms.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace crest::sampling;
using crest::kernel::dot;
using crest::kernel::SampledGrid;
using crest::kernel::Vec3;

namespace {

/// The sample at the node nearest to p.
double near(const SampledGrid& grid, const Vec3& p) {
  std::size_t i = 0;
  for (std::size_t k = 3; k-- > 0;)
    i = i * grid.size[k] +
        static_cast<std::size_t>(std::lround((p[k] - grid.origin[k]) / grid.spacing[k]));
  return grid.at(i);
}

}  // namespace

TEST_CASE("volume phantoms are bright on their sheets and dark away from them") {
  struct Place {
    const char* name;
    Vec3 bright, dark;
  };
  for (const Place& place : {Place{"sphere-shell", {0, 0.6, 0}, {0, 0, 0}},
                             Place{"ellipsoid-shell", {0, 0, 0.45}, {0, 0, 0}},
                             Place{"torus-shell", {0.78, 0, 0}, {0.5, 0, 0}},
                             Place{"genus2-shell", {0.87, 0, 0}, {0.36, 0, 0}},
                             Place{"moebius-sheet", {0.6, 0, 0}, {0, 0, 0}},
                             Place{"junction", {0, 0, 0.5}, {-0.9, -0.2, 0}}}) {
    INFO(place.name);
    const SampledGrid grid = volume_phantom(place.name, 101);
    CHECK(grid.size == std::array<std::size_t, 3>{101, 101, 101});
    CHECK(grid.spacing[0] == Approx(0.02));
    CHECK(near(grid, place.bright) > 0.95);
    CHECK(near(grid, place.dark) < 0.1);
  }
  CHECK(volume_phantoms().size() == 6);
}

TEST_CASE("points of phantoms lie on their surface, with unit normals of both signs") {
  for (const Phantom& phantom : point_phantoms()) {
    INFO(phantom.name);
    const auto sample = point_phantom(phantom.name, 2000, 0, 3);
    REQUIRE(sample.points.size() == 2000);
    REQUIRE(sample.normals.size() == 2000);
    std::size_t inward = 0;
    for (std::size_t i = 0; i < sample.points.size(); ++i) {
      const Vec3 &p = sample.points[i], &n = sample.normals[i];
      CHECK(dot(n, n) == Approx(1));
      if (phantom.name == "hemisphere-points") {
        CHECK(dot(p, p) == Approx(1));
        CHECK(p[2] >= 0);
        CHECK(std::fabs(dot(p, n)) == Approx(1));
        inward += dot(p, n) < 0 ? 1 : 0;
      } else {
        // w from the height and the distance to the axis.
        const double u = std::atan2(p[1], p[0]), r = std::hypot(p[0], p[1]) - 1;
        CHECK(std::sin(u / 2) * r == Approx(std::cos(u / 2) * p[2]).margin(1e-12));
        CHECK(std::hypot(r, p[2]) <= 0.45 + 1e-12);
        // Rulings lie in the surface.
        CHECK(dot(n, {std::cos(u / 2) * std::cos(u), std::cos(u / 2) * std::sin(u),
                      std::sin(u / 2)}) == Approx(0).margin(1e-12));
        inward += n[2] < 0 ? 1 : 0;
      }
    }
    CHECK(inward > 900);
    CHECK(inward < 1100);
    const auto again = point_phantom(phantom.name, 2000, 0, 3);
    CHECK(again.points == sample.points);
    CHECK(point_phantom(phantom.name, 2000, 0.03, 3).points != sample.points);
  }
}
