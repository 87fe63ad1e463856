// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9: lines that enclosures cannot finish: along edges, through vertices, into walls and
// zeros.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "certify/compression/encode.hpp"
#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

/// (n x n) unit cells around the origin.
PlaneField centred(std::uint32_t n, const std::function<std::array<double, 2>(double, double)>& v) {
  const double half = n / 2.0;
  auto f = grid_field(n, n, 1, [&](double x, double y) { return v(x - half, y - half); });
  for (auto& p : f.positions) p = {p[0] - half, p[1] - half};
  return f;
}

std::uint32_t corner_at(const PlaneField& f, double x, double y) {
  for (std::uint32_t t = 0; t < f.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (f.positions[f.triangles[t][k]] == std::array{x, y}) return 3 * t + k;
  throw std::invalid_argument("no such vertex");
}

/// Gives the i-th separatrix a straight way.
void straight(SkeletonCertificate& c, std::size_t i, std::uint32_t corner,
              std::array<double, 2> direction, std::uint32_t elements, SkeletonEnd end,
              std::uint32_t to) {
  SkeletonLeg leg;
  leg.kind = LegKind::straight;
  leg.corner = corner;
  leg.first = {direction[0], direction[1]};
  leg.elements = elements;
  auto& line = c.separatrices[i];
  line.legs = {leg};
  line.end = end;
  line.to = to;
  line.reason = OpenReason::none;
  --c.ends[4];
  ++c.ends[static_cast<std::size_t>(end)];
}

}  // namespace

TEST_CASE("straight: a saddle on an aligned grid, four ends at the boundary") {
  const auto f = centred(4, [](double x, double y) { return std::array{x, -y}; });
  auto c = reference_points(f);
  REQUIRE(c.zeros.size() == 1);
  CHECK(c.zeros[0].place == ZeroPlace::vertex);
  CHECK(c.zeros[0].index == -1);
  CHECK(c.zeros[0].hyperbolic == 4);
  REQUIRE(c.separatrices.size() == 4);
  REQUIRE(reason(c).empty());
  // Corners, counter-clockwise from the lower right one: region r begins at the r-th.
  REQUIRE(c.switches.size() == 4);
  const std::uint32_t z = corner_at(f, 0, 0);
  const auto boundary = SkeletonEnd::boundary;
  straight(c, 0, z, {1, 0}, 2, boundary, 0);
  straight(c, 1, z, {-1, 0}, 2, boundary, 2);
  straight(c, 2, z, {0, 1}, 2, boundary, 1);
  straight(c, 3, z, {0, -1}, 2, boundary, 3);
  CHECK(reason(c).empty());
  for (std::size_t i = 0; i < 4; ++i) {
    auto wrong = c;
    wrong.separatrices[i].to = (wrong.separatrices[i].to + 1) % 4;
    CHECK_FALSE(reason(wrong).empty());
    wrong = c;
    wrong.separatrices[i].legs[0].elements = i % 2 == 0 ? 1 : 3;
    CHECK_FALSE(reason(wrong).empty());
    wrong = c;
    wrong.separatrices[i].legs[0].first = {1, 1};
    CHECK_FALSE(reason(wrong).empty());
    wrong = c;  // one twice, one missing
    wrong.separatrices[i] = wrong.separatrices[i ^ 1U];
    CHECK_FALSE(reason(wrong).empty());
    wrong = c;
    wrong.separatrices[i].backward ^= 1U;
    CHECK_FALSE(reason(wrong).empty());
  }
}

TEST_CASE(
    "straight: the sides that lines follow are the same ones, however triangles are numbered") {
  const auto f = centred(4, [](double x, double y) { return std::array{x, -y}; });
  // Every line along edges to the boundary, to the one region where the checker finds it.
  const auto skeleton_of = [](const PlaneField& field) {
    auto c = reference_points(field);
    const std::uint32_t z = corner_at(field, 0, 0);
    std::array<int, 2> seen{};
    for (std::uint32_t i = 0; i < 4; ++i) {
      const bool backward = c.separatrices[i].backward != 0;
      const double sign = seen[backward]++ == 0 ? 1 : -1;
      auto trial = c;
      for (std::uint32_t region = 0; region < 4 && !(region > 0 && reason(trial).empty());
           ++region) {
        trial = c;
        straight(trial, i, z, {backward ? 0 : sign, backward ? sign : 0}, 2, SkeletonEnd::boundary,
                 region);
      }
      c = trial;
    }
    return c;
  };
  CompressionCertificate claim;
  claim.notion = SkeletonNotion::strong;
  claim.input = skeleton_of(f);
  claim.vertices.resize(f.positions.size());
  std::iota(claim.vertices.begin(), claim.vertices.end(), 0U);
  claim.zeros = {0};
  for (std::ptrdiff_t first = 0; first < 32; first += 3) {
    PlaneField other = f;
    std::rotate(other.triangles.begin(), other.triangles.begin() + first, other.triangles.end());
    claim.output = skeleton_of(other);
    claim.separatrices.clear();
    for (const auto& line : claim.input.separatrices)
      for (std::uint32_t k = 0; k < 4; ++k)
        if (claim.output.separatrices[k].legs[0].first == line.legs[0].first)
          claim.separatrices.push_back(k);
    CAPTURE(first);
    CHECK(reason(claim).empty());
  }
}

TEST_CASE("straight: v = (y, x), along diagonals and through the midpoints of edges") {
  const auto f = centred(4, [](double x, double y) { return std::array{y, x}; });
  auto c = reference_points(f);
  REQUIRE(c.separatrices.size() >= 4);
  REQUIRE(reason(c).empty());
  const std::uint32_t z = corner_at(f, 0, 0);
  // The regions are found by trying: exactly one is right.
  const auto region_of = [&](std::size_t i, std::array<double, 2> d, std::uint32_t elements) {
    int right = 0;
    std::uint32_t found = 0;
    for (std::uint32_t r = 0; r < c.switches.size(); ++r) {
      auto trial = c;
      straight(trial, i, z, d, elements, SkeletonEnd::boundary, r);
      if (!reason(trial).empty()) continue;
      ++right;
      found = r;
    }
    CHECK(right == 1);
    straight(c, i, z, d, elements, SkeletonEnd::boundary, found);
  };
  region_of(0, {1, 1}, 2);
  region_of(1, {-1, -1}, 2);
  region_of(2, {1, -1}, 4);
  region_of(3, {-1, 1}, 4);
  CHECK(reason(c).empty());
}

TEST_CASE("straight: from a saddle into a sink, a saddle connection, an irrational point") {
  // v = (1 - x^2 on the nodes, -y): zeros at x = -1, 1 on the axis.
  const auto f = centred(4, [](double x, double y) { return std::array{1 - x * x, -y}; });
  auto c = reference_points(f);
  REQUIRE(reason(c).empty());
  REQUIRE(c.zeros.size() == 2);
  const std::uint32_t z = corner_at(f, -1, 0);
  REQUIRE(c.zeros[0].index == -1);
  REQUIRE(c.zeros[1].index == 1);
  // The first two lines are the outward ones.
  straight(c, 0, z, {1, 0}, 2, SkeletonEnd::zero, 1);
  CHECK(reason(c).empty());
  auto wrong = c;
  wrong.separatrices[0].to = 0;
  CHECK_FALSE(reason(wrong).empty());
  wrong.separatrices[0].to = 1;
  wrong.separatrices[0].legs[0].elements = 3;
  CHECK(reason(wrong).find("beyond a zero") != std::string::npos);
}

TEST_CASE("straight: a shear has a zero line, a uniform flow slides along slip walls") {
  const auto shear = reference_points(centred(4, [](double, double y) {
    return std::array{y, 0.0};
  }));
  CHECK(reason(shear).empty());
  REQUIRE(shear.zeros.size() == 2);  // it cuts the domain
  for (const auto& z : shear.zeros) CHECK(z.place == ZeroPlace::line);
  CHECK(shear.separatrices.empty());

  const auto hole = [](std::uint32_t i, std::uint32_t j) { return i == 2 && j == 2; };
  const auto f = grid_field(
      5, 5, 1,
      [](double, double) {
        return std::array{1.0, 0.0};
      },
      hole);
  auto c = reference_points(f);
  REQUIRE(reason(c).empty());
  // The hole's upper and lower side: runs, touched from inside; two lines each.
  REQUIRE(c.separatrices.size() == 4);
  for (const auto& s : c.switches) CHECK(s.place == 2);
  std::size_t done = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool backward = c.separatrices[i].backward != 0;
    // The run begins at the left of the upper side, at the right of the lower one.
    for (const auto& [x, y] : {std::array{2.0, 3.0}, std::array{3.0, 2.0}})
      for (std::uint32_t r = 0; r < 4; ++r) {
        auto trial = c;
        const bool right = x == 3;
        const std::uint32_t elements = right != backward ? 2 : 3;
        straight(trial, i, corner_at(f, x, y), {backward ? -1.0 : 1.0, 0}, elements,
                 SkeletonEnd::boundary, r);
        // corner_at may name a corner of another fan only at pinches: there are none.
        if (!reason(trial).empty()) continue;
        c = trial;
        ++done;
        break;
      }
  }
  CHECK(done == 4);
  CHECK(c.ends[2] == 4);
  CHECK(reason(c).empty());
}
