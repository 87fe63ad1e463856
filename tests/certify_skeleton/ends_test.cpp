// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9: ends that the lattice fields do not have (polygons around vertices, walls), and more
// bits.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

std::array<double, 2> minus(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
double cross(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// The segment around the ray of a vertex zero that leaves through the side across from it to the
/// right; corner: the side.
SkeletonLeg ray_to_the_right(const PlaneField& f, std::array<double, 2> z) {
  for (std::uint32_t t = 0; t < f.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto at = [&](std::uint32_t i) { return f.triangles[t][(k + i) % 3]; };
      if (f.positions[at(2)] != z) continue;
      const auto d0 = minus(f.positions[at(0)], z), d1 = minus(f.positions[at(1)], z);
      const auto &v0 = f.vectors[at(0)], &v1 = f.vectors[at(1)];
      const auto q = [&](double s) {
        const std::array d{d0[0] + s * (d1[0] - d0[0]), d0[1] + s * (d1[1] - d0[1])},
            v{v0[0] + s * (v1[0] - v0[0]), v0[1] + s * (v1[1] - v0[1])};
        return d[0] > 0 && v[0] > 0 ? cross(d, v) : std::nan("");
      };
      for (int i = 0; i < 1000; ++i) {
        double low = (i + 1e-9) / 1000, high = (i + 1 - 1e-9) / 1000;
        if (!(q(low) * q(high) < 0)) continue;
        const bool rising = q(high) > 0;
        for (int j = 0; j < 60; ++j)
          ((q((low + high) / 2) > 0) == rising ? high : low) = (low + high) / 2;
        const auto place = [](double s) { return s <= 0.5 ? s : s - 1; };
        SkeletonLeg leg;
        leg.corner = 3 * t + k;
        leg.first = {place(low + 1e-10)};
        leg.second = {place(low - 1e-10)};
        leg.barrier.degree = 12;
        return leg;
      }
    }
  throw std::invalid_argument("no ray to the right");
}

/// Tries all turns of up to six triangles for line 0; how many are accepted.
int search(SkeletonCertificate& c, const SkeletonLeg& leg, SkeletonEnd end, std::uint32_t to) {
  int accepted = 0;
  auto found = c;
  for (std::size_t length = 0; length <= 6; ++length) {
    int codes = 1;
    for (std::size_t i = 0; i < length; ++i) codes *= 3;
    for (int code = 0; code < codes; ++code) {
      auto trial = c;
      auto& line = trial.separatrices[0];
      line.legs = {leg};
      for (int rest = code; line.legs[0].turns.size() < length; rest /= 3)
        line.legs[0].turns.push_back(static_cast<Turn>(rest % 3));
      line.end = end;
      line.to = to;
      line.reason = OpenReason::none;
      --trial.ends[4];
      ++trial.ends[static_cast<std::size_t>(end)];
      if (!reason(trial).empty()) continue;
      ++accepted;
      found = trial;
    }
  }
  c = found;
  return accepted;
}

std::uint32_t corner_at(const PlaneField& f, std::uint32_t t, double x, double y) {
  for (std::uint32_t k = 0; k < 3; ++k)
    if (f.positions[f.triangles[t][k]] == std::array{x, y}) return 3 * t + k;
  return kNotStated;
}

}  // namespace

TEST_CASE("ends: a polygon around a sink on a vertex") {
  // A saddle at (1, 2), a sink at (3, 2), and one vector between them that is not straight.
  auto f = grid_field(4, 4, 1, [](double x, double y) {
    return std::array{1 - (x - 2) * (x - 2), 2 - y};
  });
  f.vectors[2 * 5 + 2] = {1, 0.25};
  auto c = reference_points(f);
  REQUIRE(reason(c).empty());
  REQUIRE(c.zeros.size() == 2);
  REQUIRE(c.zeros[0].index == -1);
  SkeletonTrap trap;
  trap.zero = 1;
  // The neighbours of the sink, counter-clockwise: half way to each of them.
  const std::array<double, 2> round[6] = {{4, 2}, {4, 3}, {3, 3}, {2, 2}, {2, 1}, {3, 1}};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::uint32_t t = 0; t < f.triangles.size(); ++t) {
      const std::uint32_t at = corner_at(f, t, 3, 2);
      const auto& next = round[(i + 1) % 6];
      if (at != kNotStated && corner_at(f, t, round[i][0], round[i][1]) != kNotStated &&
          corner_at(f, t, next[0], next[1]) != kNotStated)
        trap.star.push_back({at, 0.5, 0});
    }
  REQUIRE(trap.star.size() == 6);
  c.traps = {trap};
  REQUIRE(reason(c) == "");
  const auto leg = ray_to_the_right(f, {1, 2});
  CHECK(search(c, leg, SkeletonEnd::zero, 1) > 0);
  CHECK(c.ends[0] == 1);
  CHECK(reason(c) == "");
  auto wrong = c;
  wrong.separatrices[0].to = 0;
  CHECK_FALSE(reason(wrong).empty());
  const auto refused = [&](const std::function<void(SkeletonTrap&)>& edit) {
    auto other = c;
    edit(other.traps[0]);
    return !reason(other).empty();
  };
  CHECK(refused([](auto& t) { t.star.pop_back(); }));
  CHECK(refused([](auto& t) { std::swap(t.star[1], t.star[2]); }));
  CHECK(refused([](auto& t) { t.star[0].a = 1; }));
  CHECK(refused([](auto& t) { t.star[0].b = 0.1; }));
  CHECK(refused([](auto& t) { t.star[0].corner = kNotStated; }));
  CHECK(refused([](auto& t) { t.star.insert(t.star.end(), t.star.begin(), t.star.end()); }));
  CHECK(refused([](auto& t) { t.form[0] = 1; }));
  CHECK(refused([](auto& t) { t.zero = 0; }));
}

TEST_CASE("ends: a wall") {
  // Nothing flows from x = 3 on; a saddle at (1, 2).
  auto f = grid_field(4, 4, 1, [](double x, double y) {
    return x >= 3 ? std::array{0.0, 0.0} : std::array{x - 1, 2 - y};
  });
  f.vectors[2 * 5 + 2] = {1, 0.25};
  auto c = reference_points(f);
  REQUIRE(reason(c) == "");
  REQUIRE(c.zeros.size() == 2);
  const std::size_t wall = c.zeros[0].place == ZeroPlace::region ? 0 : 1;
  REQUIRE(c.zeros[wall].place == ZeroPlace::region);
  REQUIRE(c.zeros[1 - wall].index == -1);
  const auto leg = ray_to_the_right(f, {1, 2});
  CHECK(search(c, leg, SkeletonEnd::zero, static_cast<std::uint32_t>(wall)) > 0);
  CHECK(c.ends[0] == 1);
  auto wrong = c;
  wrong.separatrices[0].legs[0].turns.pop_back();
  CHECK_FALSE(reason(wrong).empty());
}

TEST_CASE("ends: the same lines with 133, 332 and 1000 bits") {
  const auto c = reference_skeleton(lattice_field(1, 4, 12, true));
  REQUIRE(reason(c) == "");
  std::size_t tried = 0;
  for (std::size_t i = 0; i < c.separatrices.size() && tried < 4; ++i) {
    if (c.separatrices[i].legs.empty() || c.separatrices[i].legs[0].turns.size() > 12) continue;
    ++tried;
    for (const SkeletonBarrier& barrier :
         {SkeletonBarrier{24, 90, 133, 0}, SkeletonBarrier{50, 240, 332, 0},
          SkeletonBarrier{120, 720, 1000, 0}}) {
      auto more = c;
      more.separatrices[i].legs[0].barrier = barrier;
      INFO("separatrix " << i << ", " << barrier.bits << " bits");
      CHECK(reason(more) == "");
      auto& turn = more.separatrices[i].legs[0].turns.back();
      turn = turn == Turn::left ? Turn::right : Turn::left;
      CHECK_FALSE(reason(more).empty());
    }
  }
  CHECK(tried > 0);
}
