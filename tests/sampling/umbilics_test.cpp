// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/umbilics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace crest::sampling {
namespace {

struct Count {
  int plus = 0, minus = 0, other = 0;
};
Count count(const std::vector<ExactUmbilic>& umbilics) {
  Count c;
  for (const ExactUmbilic& u : umbilics)
    ++(u.twice_index > 0 ? c.plus : u.twice_index < 0 ? c.minus : c.other);
  return c;
}

}  // namespace

TEST_CASE("the umbilics found are those known, and their indices sum to chi") {
  for (const std::string name :
       {"ellipsoid", "blend", "perturbed-torus", "quartic-sphere", "umbilic-patch"}) {
    const Surface surface = make_surface(name, {}, true);
    for (const int vertices : {2500, 10000}) {
      INFO(name << " " << vertices);
      const SurfaceSample mesh = sample(surface, vertices, true);
      const Count c = count(find_umbilics(surface, mesh));
      REQUIRE(c.other == 0);
      if (surface.known.boundary_loops == 0)
        REQUIRE(c.plus - c.minus == 2 * surface.known.euler_characteristic);
      if (surface.known.umbilics) {
        REQUIRE(c.plus == surface.known.umbilics->plus);
        REQUIRE(c.minus == surface.known.umbilics->minus);
      }
    }
  }
}

TEST_CASE("Newton's method ends at the ellipsoid's closed-form umbilics") {
  const Surface surface = make_surface("ellipsoid", {1, 1.5, 2}, false);
  const double x = std::sqrt(1.25 / 3), z = 2 * std::sqrt(1.75 / 3);
  for (const ExactUmbilic& u : find_umbilics(surface, sample(surface, 2500, true))) {
    REQUIRE(std::abs(u.point[0]) == Approx(x).epsilon(1e-12));
    REQUIRE(std::abs(u.point[1]) < 1e-12);
    REQUIRE(std::abs(u.point[2]) == Approx(z).epsilon(1e-12));
  }
}

TEST_CASE("the sign of the cubic's winding gives the patch's index") {
  for (const double sign : {-1.0, 1.0}) {
    // b2 = -1: 3-ridge star, index -1/2; b0 = 3, b2 = 1: index +1/2.
    const Surface s =
        make_surface("umbilic-patch", {0.5, sign > 0 ? 3.0 : 1.0, 0, sign, 0, 0.2}, false);
    const auto found = find_umbilics(s, sample(s, 400, false));
    REQUIRE(found.size() == 1);
    REQUIRE(found[0].twice_index == (sign > 0 ? 1 : -1));
    REQUIRE(norm(to_point(found[0].point)) < 1e-12L);
  }
}

}  // namespace crest::sampling
