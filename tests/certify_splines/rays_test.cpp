// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 11: masks, true certificates, degenerate rays.
#include <catch2/catch.hpp>
#include <set>

#include "certify/exact/quadratic_spline.hpp"
#include "certify/spline_rays/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_splines/reference_rays.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

double small_integer(Random& random) {
  return static_cast<double>(random() % 21) - 10;
}
SplineVolume random_volume(const std::array<std::uint32_t, 3>& nodes, double level, Random& random,
                           bool extended = false) {
  return sampled_volume(
      nodes, level, [&](double, double, double) { return small_integer(random); }, extended);
}
double square_distance(double x, double y, double z) {
  return (x - 3) * (x - 3) + (y - 3) * (y - 3) + (z - 3) * (z - 3);
}

}  // namespace

TEST_CASE("splines: the table of masks is the repeated averages of the paper") {
  Random random(kSeed);
  std::size_t points = 0;
  for (const bool extended : {false, true}) {
    const auto volume = random_volume({3, 4, 3}, 0, random, extended);
    const QuadraticSpline spline(volume);
    const ReferenceSpline reference(volume);
    for (std::size_t cube = 0; cube < spline.cube_count(); ++cube) {
      const CubePosition at = spline.position(cube);
      const Int3 place = {static_cast<int>(at[0]), static_cast<int>(at[1]),
                          static_cast<int>(at[2])};
      const auto samples = spline.neighbourhood<Rational>(at);
      for (unsigned number = 0; number < kTetrahedra; ++number) {
        const Tetrahedron tet = tetrahedron(number);
        REQUIRE(tet.vertices() == reference_tets()[number].vertices);
        const auto q = quadratic(samples, tet);
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t j = 0; j < 4; ++j, ++points) {
            Int3 p;
            for (std::size_t k = 0; k < 3; ++k) p[k] = tet.vertices()[i][k] + tet.vertices()[j][k];
            CHECK(q[i][j] == reference.coefficient(place, p));
          }
      }
    }
  }
  CHECK(points == (2 + 36) * 24 * 16);
}

TEST_CASE("splines: negative weights of a mask are at most a sixteenth") {
  for (const auto& tet : reference_tets())
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        Int3 p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = tet.vertices[i][k] + tet.vertices[j][k];
        int negative = 0, sum = 0;
        for (const int weight : spline_mask(p).weights) {
          negative -= std::min(weight, 0);
          sum += weight;
        }
        CHECK(sum == spline_mask(p).sum);
        CHECK(16 * negative <= sum);
      }
}

TEST_CASE("splines: signs give the tetrahedron, of every point, moved by e, e^2, e^3") {
  Random random(kSeed);
  std::set<unsigned> found;
  for (int i = 0; i < 2000; ++i) {
    const std::array<double, 3> d = {static_cast<double>(random() % 5) - 2,
                                     static_cast<double>(random() % 5) - 2,
                                     static_cast<double>(random() % 5) - 2};
    unsigned signs = 0;
    const double forms[] = {d[0] + d[1], d[0] - d[1], d[0] + d[2],
                            d[0] - d[2], d[1] + d[2], d[1] - d[2]};
    for (unsigned k = 0; k < 6; ++k) signs |= forms[k] >= 0 ? 1U << k : 0U;
    const unsigned number = tetrahedron_by_signs(signs);
    found.insert(number);
    const auto l = reference_tets()[number].barycentrics(
        {d[0] + Rational(0x1p-20), d[1] + Rational(0x1p-40), d[2] + Rational(0x1p-60)});
    CHECK((l[1] > 0 && l[2] > 0 && l[3] > 0));
  }
  CHECK(found.size() == kTetrahedra);
}

TEST_CASE("splines: rays through random volumes are accepted as the reference casts them") {
  Random random(kSeed);
  std::size_t hits = 0, rays = 0;
  for (std::uint64_t i = 0; i < scaled(12); ++i) {
    const bool extended = i % 2 == 1;
    auto volume = random_volume({4, 5, 4}, i % 3 == 0 ? 0.0 : 3.25, random, extended);
    if (i % 4 > 1) {
      volume.origin = {small_integer(random), 0.3, -7};
      volume.spacing = {0.5, 0.7, 3};
      volume.direction = {0, 1, 0.25, i % 4 == 2 ? 1.0 : -1.0, 0, 0, 0, 0.1, 1};
    }
    std::vector<std::array<double, 6>> list;
    for (int k = 0; k < 20; ++k) {
      std::array<double, 6> ray{};
      for (double& x : ray) x = small_integer(random) / (k % 2 == 0 ? 1 : 3);
      for (std::size_t d = 0; d < 3; ++d) ray[3 + d] = (1.5 - ray[d]) / 2 + ray[3 + d] / 8;
      list.push_back(ray);
    }
    const auto c = reference_rays(volume, list);
    require_accepted(c);
    hits += c.hits.size();
    rays += list.size();
  }
  CHECK(hits > rays / 6);
  CHECK(hits < rays);
}

TEST_CASE("splines: rays through vertices, edges and planes, and along them, are decided") {
  // Cubes have their vertices at halves, their centres at integers.
  const auto sphere = sampled_volume({7, 7, 7}, 4, square_distance);
  std::vector<std::array<double, 6>> list;
  for (const double x : {0.5, 1.0, 1.5, 2.5, 3.0, 3.5, 5.5})
    for (const double y : {0.5, 2.5, 3.0, 4.0})
      for (const auto& d : {Int3{0, 0, 1}, {1, 1, 1}, {1, 1, 0}, {1, 0, -1}, {-2, 1, 0}}) {
        list.push_back({x, y, 0.5, static_cast<double>(d[0]), static_cast<double>(d[1]),
                        static_cast<double>(d[2])});
        list.push_back({x - 4 * d[0], y - 4 * d[1], 3 - 4.0 * d[2], static_cast<double>(d[0]),
                        static_cast<double>(d[1]), static_cast<double>(d[2])});
      }
  const auto c = reference_rays(sphere, list);
  CHECK(c.hits.size() > list.size() / 4);
  require_accepted(c);
  // Plateaus, and the level on one of them.
  auto steps = sampled_volume({7, 7, 7}, 2, [](double x, double y, double z) {
    return std::min(2.0, std::floor((x + y + z) / 3));
  });
  require_accepted(reference_rays(steps, list));
}

TEST_CASE("splines: a ray that touches the sphere is a hit, moved outwards a miss") {
  // s = |x - c|^2 + 3/4 in index coordinates, so the sphere's radius is sqrt(level - 3/4) = 2.
  const auto sphere = sampled_volume({9, 9, 9}, 4.75, [](double x, double y, double z) {
    return (x - 4) * (x - 4) + (y - 4) * (y - 4) + (z - 4) * (z - 4);
  });
  for (const double move : {0.0, 0x1p-40, -0x1p-40}) {
    const auto c =
        reference_rays(sphere, {{2 + move, 4, 1, 0, 0, 1}, {2 + move, 3.7, 1, 0, 0.1, 1}});
    CHECK(c.meets[0] == (move < 0 ? 0 : 1));
    require_accepted(c);
    auto lie = c;
    lie.meets[0] ^= 1;
    if (move < 0)
      lie.hits.insert(lie.hits.begin(), {0, 0, 3, 3});
    else
      lie.hits.erase(lie.hits.begin());
    CHECK(reason(lie).starts_with("ray 0 "));
  }
}

TEST_CASE("splines: a domain met in one point is not skipped") {
  // s of the domain's corner (1/2, 1/2, 1/2) is the mean of |x|^2 over the unit cube's corners,
  // 3/2.
  const auto f = [](double x, double y, double z) { return x * x + y * y + z * z; };
  const auto at_corner = sampled_volume({4, 4, 4}, 1.5, f);
  const std::vector<std::array<double, 6>> through = {
      {0.5, 0.5, 0.5, -1, -1, -1}, {-0.5, 1.5, 0.5, 1, -1, 0}, {0.5, 0.5, 0.5, 1, 1, 1}};
  const auto c = reference_rays(at_corner, through);
  CHECK(c.hits.size() == 3);
  CHECK(c.hits[1].low == 1);
  require_accepted(c);
  auto missed = c;
  missed.meets = {0, 1, 1};
  missed.hits.erase(missed.hits.begin());
  CHECK(reason(missed) == "ray 0 has a zero");
  auto other = c;
  other.hits[1].tetrahedron ^= 1;
  CHECK(reason(other).starts_with("ray 1 "));
  auto elsewhere = sampled_volume({4, 4, 4}, 1.25, f);
  const auto none = reference_rays(elsewhere, {through[0], through[1]});
  CHECK(none.hits.empty());
  require_accepted(none);
}
