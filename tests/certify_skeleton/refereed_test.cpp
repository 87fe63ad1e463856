// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9: the cases in which the theorems of the first draft were wrong, with their numbers.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "certify/skeleton/arc.hpp"
#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;
using Vec = std::array<double, 2>;

namespace {

/// A closed fan around the origin; vectors at the rim.
PlaneField closed_fan(const std::vector<Vec>& rim, const std::vector<Vec>& vectors) {
  PlaneField f{{{0, 0}}, {}, {{0, 0}}};
  const auto n = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    f.positions.push_back(rim[i]);
    f.vectors.push_back(vectors[i]);
    f.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return f;
}

}  // namespace

TEST_CASE("refereed 1: the same rays, elliptic or hyperbolic by the turning") {
  for (const double t : {2.0, -2.0}) {
    const std::vector<Vec> rim = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                  {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const std::vector<Vec> vectors = {{1, 0},  {-t, t}, {0, -1}, {t, t},
                                      {-1, 0}, {t, -t}, {0, 1},  {-t, -t}};
    auto c = reference_points(closed_fan(rim, vectors));
    REQUIRE(c.zeros.size() == 1);
    CHECK(c.zeros[0].index == (t > 0 ? 3 : -1));
    CHECK(c.zeros[0].elliptic == (t > 0 ? 4U : 0U));
    CHECK(c.zeros[0].hyperbolic == (t > 0 ? 0U : 4U));
    CHECK(reason(c).empty());
    std::swap(c.zeros[0].elliptic, c.zeros[0].hyperbolic);
    CHECK_FALSE(reason(c).empty());
  }
}

TEST_CASE("refereed 1: index = 1 + (elliptic - hyperbolic) / 2 in random fans") {
  Random random(kSeed);
  std::size_t hyperbolic = 0, elliptic = 0;
  for (std::uint64_t i = 0; i < scaled(150); ++i) {
    std::vector<Vec> rim, vectors;
    const int n = 3 + static_cast<int>(random() % 5);
    for (int k = 0; k < n; ++k) {
      const double angle =
          2 * M_PI * (k + 0.2 * std::ldexp(static_cast<double>(random() >> 11U), -53)) / n;
      rim.push_back({std::round(64 * std::cos(angle)), std::round(64 * std::sin(angle))});
      const auto number = [&] { return static_cast<double>(static_cast<int>(random() % 9) - 4); };
      const double x = number();
      vectors.push_back({x, number()});
    }
    const auto c = reference_points(closed_fan(rim, vectors));
    bool plain = c.zeros.size() == 1 && c.zeros[0].index != kNoIndex;
    INFO("fan " << i << ": " << reason(c));
    CHECK(reason(c).empty());  // the checker requires the equation
    if (!plain) continue;
    hyperbolic += c.zeros[0].hyperbolic;
    elliptic += c.zeros[0].elliptic;
  }
  std::cout << "random fans: " << hyperbolic << " hyperbolic, " << elliptic
            << " elliptic sectors\n";
  CHECK(hyperbolic > 0);
  CHECK(elliptic > 0);
}

TEST_CASE("refereed 2: a zero on the boundary has no index") {
  // v = x at the vertices, half fan; and the edge zero of (-1, 0), (1, 0).
  const PlaneField half{
      {{0, 0}, {1, 0}, {0, 1}, {-1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {{0, 0}, {1, 0}, {0, 1}, {-1, 0}}};
  const PlaneField edge{{{-1, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {{-1, 0}, {1, 0}, {0, 1}}};
  for (const PlaneField& f : {half, edge}) {
    auto c = reference_points(f);
    REQUIRE(c.zeros.size() == 1);
    CHECK(c.zeros[0].index == kNoIndex);
    CHECK(reason(c).empty());
    for (const int index : {0, 1}) {
      auto wrong = c;
      wrong.zeros[0].index = wrong.index_sum = index;
      CHECK_FALSE(reason(wrong).empty());
    }
  }
}

namespace {

/// A triangle, v affine in it, and two paths of straight pieces: what lemma 13 asks for.
struct UnitCell {
  std::array<Vec, 3> corner;  ///< entered through side 0, left through `exit`
  std::array<Vec, 3> vector;
  int exit = 1;
  std::vector<Vec> left, right;  ///< from side 0 to the exit

  Vec at(const Vec& x) const {
    const Vec e{corner[1][0] - corner[0][0], corner[1][1] - corner[0][1]},
        f{corner[2][0] - corner[0][0], corner[2][1] - corner[0][1]},
        d{x[0] - corner[0][0], x[1] - corner[0][1]};
    const double area = e[0] * f[1] - e[1] * f[0], a = (d[0] * f[1] - d[1] * f[0]) / area,
                 b = (e[0] * d[1] - e[1] * d[0]) / area;
    Vec v;
    for (std::size_t k = 0; k < 2; ++k)
      v[k] = vector[0][k] + a * (vector[1][k] - vector[0][k]) + b * (vector[2][k] - vector[0][k]);
    return v;
  }
  /// Positive into the triangle.
  double normal(int side, const Vec& x) const {
    const auto s = static_cast<std::size_t>(side);
    const Vec &p = corner[s], &q = corner[(s + 1) % 3], v = at(x);
    return (q[0] - p[0]) * v[1] - (q[1] - p[1]) * v[0];
  }
  bool entered() const { return normal(0, left[0]) > 0 && normal(0, right[0]) > 0; }
  bool strictly_out() const {
    return normal(exit, left.back()) < 0 && normal(exit, right.back()) < 0;
  }
  bool one_way(bool with_field) const {
    for (const int turn : {1, -1}) {
      const auto& path = turn > 0 ? left : right;
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Vec d{path[i + 1][0] - path[i][0], path[i + 1][1] - path[i][1]};
        for (const Vec& x : {path[i], path[i + 1]}) {
          const Vec v = at(x);
          if (turn * (d[0] * v[1] - d[1] * v[0]) >= -1e-12) return false;
          if (with_field && d[0] * v[0] + d[1] * v[1] <= 1e-12) return false;
        }
      }
    }
    return true;
  }
  /// Does the line through the middle of J leave through the exit? -1: not seen to leave at all.
  int leaves() const {
    Vec x{(left[0][0] + right[0][0]) / 2, (left[0][1] + right[0][1]) / 2};
    double speed = 0;
    for (const Vec& v : vector) speed = std::max(speed, std::hypot(v[0], v[1]));
    const double h = 0.002 / speed;
    for (int i = 0; i < 200000; ++i) {
      const Vec v = at(x), w = at({x[0] + h / 2 * v[0], x[1] + h / 2 * v[1]});
      x = {x[0] + h * w[0], x[1] + h * w[1]};
      for (int s = 0; s < 3; ++s) {
        const auto k = static_cast<std::size_t>(s);
        const Vec &p = corner[k], &q = corner[(k + 1) % 3];
        if (i > 2 && (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]) < 0)
          return s == exit;
      }
    }
    return -1;
  }
};

}  // namespace

TEST_CASE("refereed 3: one-way arcs through one edge do not prove the crossing") {
  UnitCell cell{{{{-4, -3}, {4, -3}, {0, 5}}},
                {{{4, 3}, {-4, 3}, {0, -5}}},
                1,
                {{-.1, -3},
                 {-1.3, -2.6},
                 {-2.3, -1.4},
                 {-2.2, 0},
                 {-1.5, 1.4},
                 {0, 2.2},
                 {.9, 1.9},
                 {1.55, 1.9}},
                {{.1, -3}, {1.2, -2.5}, {1.9, -1.5}, {2.1, -.5}, {2.2, .6}}};
  CHECK(cell.entered());
  CHECK(cell.one_way(false));
  CHECK(cell.leaves() == -1);  // it ends in the sink
  CHECK_FALSE(cell.strictly_out());
  CHECK(cell.normal(1, cell.left.back()) > 0);
  CHECK_FALSE(cell.one_way(true));

  // In a certificate: the line from the bottom is said to cross to the right.
  const PlaneField f{{{-4, -3}, {4, -3}, {0, 5}}, {{0, 1, 2}}, {{4, 3}, {-4, 3}, {0, -5}}};
  auto c = reference_points(f);
  CHECK(reason(c).empty());
  SkeletonOrbit orbit;
  orbit.left = 0.4;
  orbit.right = -0.4;
  orbit.turns = {Turn::right};
  c.orbits = {orbit};
  CHECK(reason(c).find("orbit 0, triangle 0") == 0);
}

TEST_CASE("item 10: what fails without a condition of the cell lemma") {
  // Random affine fields with a zero inside and random broken lines, as many as the time allows.
  Random random(kSeed);
  const auto number = [&](double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11U), -53);
  };
  std::array<std::size_t, 4> accepted{}, wrong{};
  for (std::uint64_t i = 0; i < scaled(120000); ++i) {
    UnitCell cell{{{{-4, -3}, {4, -3}, {0, 5}}}, {}, 1 + static_cast<int>(random() % 2), {}, {}};
    const Vec z{number(-2, 2), number(-2, 1)};
    const double a = number(-1, 1), b = number(-2, 2), c = number(-2, 2), d = number(-1, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec x{cell.corner[k][0] - z[0], cell.corner[k][1] - z[1]};
      cell.vector[k] = {a * x[0] + b * x[1], c * x[0] + d * x[1]};
    }
    // Paths that follow the field roughly, turned by up to a right angle and more.
    const double middle = number(-3, 3);
    for (const int turn : {1, -1}) {
      auto& path = turn > 0 ? cell.left : cell.right;
      Vec x{middle - turn * 0.1, -3};
      path.push_back(x);
      const double most = number(0.1, 2.4);
      for (int step = 0; step < 60; ++step) {
        const Vec v = cell.at(x);
        const double size = std::hypot(v[0], v[1]), angle = turn * number(0.02, most);
        if (size < 1e-9) break;
        const double s = std::sin(angle), co = std::cos(angle), length = number(0.2, 0.6) / size;
        Vec y{x[0] + length * (co * v[0] - s * v[1]), x[1] + length * (s * v[0] + co * v[1])};
        double cut = 1;
        int through = -1;
        for (int side = 0; side < 3; ++side) {
          const auto k = static_cast<std::size_t>(side);
          const Vec &p = cell.corner[k], &q = cell.corner[(k + 1) % 3];
          const auto height = [&](const Vec& w) {
            return (q[0] - p[0]) * (w[1] - p[1]) - (q[1] - p[1]) * (w[0] - p[0]);
          };
          if (height(y) < 0 && height(x) / (height(x) - height(y)) < cut) {
            cut = height(x) / (height(x) - height(y));
            through = side;
          }
        }
        y = {x[0] + cut * (y[0] - x[0]), x[1] + cut * (y[1] - x[1])};
        path.push_back(y);
        x = y;
        if (through < 0) continue;
        if (through != cell.exit) path.clear();
        break;
      }
      if (path.empty()) break;
      const Vec &p = cell.corner[static_cast<std::size_t>(cell.exit)],
                &q = cell.corner[static_cast<std::size_t>((cell.exit + 1) % 3)];
      const double off = (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
      if (std::fabs(off) > 1e-9) path.clear();
    }
    if (cell.left.empty() || cell.right.empty() || !cell.entered()) continue;
    // The left end of I is nearer to the head of the exit.
    const Vec &p = cell.corner[static_cast<std::size_t>(cell.exit)],
              &q = cell.corner[static_cast<std::size_t>((cell.exit + 1) % 3)];
    const Vec &l = cell.left.back(), &r = cell.right.back();
    if ((l[0] - r[0]) * (q[0] - p[0]) + (l[1] - r[1]) * (q[1] - p[1]) <= 0) continue;
    if (!cell.one_way(false)) continue;
    const bool out = cell.strictly_out(), field = cell.one_way(true);
    const bool leaves = cell.leaves() == 1;
    const std::array holds = {out && field, field, out, true};
    for (std::size_t k = 0; k < 4; ++k) {
      accepted[k] += holds[k];
      wrong[k] += holds[k] && !leaves;
    }
  }
  std::cout << "cell lemma: " << accepted[0] << " accepted, " << wrong[0]
            << " wrong; without the sign on I " << accepted[1] << ", " << wrong[1]
            << "; without x'.v > 0 " << accepted[2] << ", " << wrong[2] << "; without both "
            << accepted[3] << ", " << wrong[3] << "\n";
  CHECK(accepted[0] > 100);
  CHECK(wrong[0] == 0);
  CHECK(wrong[3] > 0);
}

TEST_CASE("refereed 6: two orbits around no zero of their own, and no separatrix") {
  auto c = reference_points(ring_field({{1, 1}, {1.5, -0.5}, {2, 1}}));
  CHECK(c.zeros.empty());
  CHECK(c.switches.empty());
  REQUIRE(c.loops.size() == 2);
  CHECK(reason(c).empty());
  // At x = 1.308 and, backward, 1.653 on the spokes 0 - 8, 8 - 16; all around.
  SkeletonOrbit attracting;
  attracting.side = 0;
  attracting.left = -0.43;
  attracting.right = -0.34;
  for (int i = 0; i < 8; ++i)
    attracting.turns.insert(attracting.turns.end(), {Turn::left, Turn::right});
  SkeletonOrbit repelling;
  repelling.side = 3 * (2 * (8 + 7) + 1) + 1;
  repelling.backward = 1;
  // Entered from the other side: the tail is outside.
  repelling.left = -0.35;
  repelling.right = -0.25;
  for (int i = 0; i < 8; ++i)
    repelling.turns.insert(repelling.turns.end(), {Turn::left, Turn::right});
  c.orbits = {attracting, repelling};
  CHECK(reason(c) == "");
  for (const double shift : {0.1, -0.1}) {  // beside the orbits
    auto wrong = c;
    wrong.orbits[0].left += shift;
    wrong.orbits[0].right += shift;
    CHECK_FALSE(reason(wrong).empty());
    wrong = c;
    wrong.orbits[1].left += shift;
    wrong.orbits[1].right += shift;
    CHECK_FALSE(reason(wrong).empty());
  }
  auto wrong = c;
  wrong.orbits[0].backward = 1;
  CHECK_FALSE(reason(wrong).empty());
  // Without the middle ring every line crosses, and there is no orbit to be stated.
  auto none = reference_points(ring_field({{1, 1}, {2, 1}}));
  CHECK(reason(none).empty());
  none.orbits = {attracting};
  CHECK_FALSE(reason(none).empty());
}

TEST_CASE("refereed 5: a loop of slip walls has a zero at each of its corners") {
  // Along all four sides of the square, so 0 at its corners; strong inside.
  auto c = reference_points(grid_field(4, 4, 1, [](double x, double y) {
    const double inner = x * (4 - x), other = y * (4 - y);
    return std::array{inner * (y - 2), other * (2 - x)};
  }));
  REQUIRE(c.loops.size() == 1);
  CHECK(c.loops[0].zero == 1);
  CHECK(c.switches.empty());
  CHECK(reason(c) == "");
  auto wrong = c;
  wrong.loops[0].zero = 0;
  wrong.loops[0].winding = wrong.loops[0].turning = 1;
  CHECK_FALSE(reason(wrong).empty());
}

TEST_CASE("refereed 8: a segment beside the ray's exit is no start of it") {
  const auto c = reference_skeleton(lattice_field(1, 4, 12, false));
  std::size_t tried = 0;
  for (std::size_t i = 0; i < c.separatrices.size(); ++i) {
    if (c.separatrices[i].legs.empty() || c.separatrices[i].legs[0].kind != LegKind::ray) continue;
    const auto& leg = c.separatrices[i].legs[0];
    const double width = leg.first[0] - leg.second[0];
    for (const double shift : {-2 * width, 2 * width}) {
      auto wrong = c;
      auto& moved = wrong.separatrices[i].legs[0];
      moved.first = {leg.first[0] + shift};
      moved.second = {leg.second[0] + shift};
      CHECK(reason(wrong).find("no ray of the zero passes") != std::string::npos);
      ++tried;
    }
  }
  CHECK(tried > 10);
}

TEST_CASE("refereed 9: a star node on a vertex has no sectors and no separatrix") {
  const std::vector<Vec> rim = {{2, 0}, {1, 2}, {-2, 1}, {-1, -2}};
  auto c = reference_points(closed_fan(rim, rim));
  REQUIRE(c.zeros.size() == 1);
  CHECK(c.zeros[0].place == ZeroPlace::vertex);
  CHECK(c.zeros[0].index == 1);
  CHECK(c.zeros[0].hyperbolic == 0);
  CHECK(c.zeros[0].elliptic == 0);
  CHECK(c.separatrices.empty());
  CHECK(reason(c).empty());
  // Around it: switch points at the rim, but no ray of the zero.
  std::vector<Vec> turned;
  for (const Vec& p : rim) turned.push_back({-p[1], p[0]});
  c = reference_points(closed_fan(rim, turned));
  CHECK(c.zeros[0].index == 1);
  for (const auto& line : c.separatrices) CHECK(line.origin == SkeletonOrigin::switch_point);
  CHECK(reason(c).empty());
}
