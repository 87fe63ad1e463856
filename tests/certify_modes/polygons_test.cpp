// SPDX-License-Identifier: GPL-3.0-or-later
// Simple and nested polygons, against all pairs in integers.
#include "certify/modes/polygons.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify::modes;
using namespace crest::tests;
using crest::kernel::Rational;

namespace {

using Whole = std::array<std::int64_t, 2>;

/// Points on a grid, as doubles that are wrong by up to `error`.
PlanarPoints planar(const std::vector<Whole>& points, double error, Random& random) {
  std::uniform_real_distribution<double> off(-error, error);
  std::vector<Planar<double>> near;
  for (const auto& [x, y] : points)
    near.push_back({static_cast<double>(x) + off(random), static_cast<double>(y) + off(random)});
  return {near, 1.01 * error + 1e-14, [points] {
            PlanarPoints::Exact exact;
            for (const auto& [x, y] : points) exact.push_back({Rational(x), Rational(y)});
            return exact;
          }};
}

std::int64_t cross(const Whole& a, const Whole& b, const Whole& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
bool on(const Whole& p, const Whole& a, const Whole& b) {
  return cross(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}
int sign(std::int64_t x) {
  return (x > 0) - (x < 0);
}
bool meet(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  if (on(a, c, d) || on(b, c, d) || on(c, a, b) || on(d, a, b)) return true;
  return sign(cross(a, b, c)) != sign(cross(a, b, d)) &&
         sign(cross(c, d, a)) != sign(cross(c, d, b));
}
/// Of a closed polygon: no two edges have a point in common but neighbours their common end.
bool naively_simple(const std::vector<Whole>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Whole &a = p[i], &b = p[(i + 1) % n];
    if (a == b) return false;
    for (std::size_t k = i + 1; k < n; ++k) {
      const Whole &c = p[k], &d = p[(k + 1) % n];
      const bool next = k == i + 1, last = (k + 1) % n == i;
      if (next && last) return false;
      if (next ? on(d, a, b) || on(a, c, d) : last ? on(c, a, b) || on(b, c, d) : meet(a, b, c, d))
        return false;
    }
  }
  return true;
}
/// Winding by quadrants would do; here: crossings of a ray that hits no vertex.
bool naively_inside(const std::vector<Whole>& p, const Whole& q) {
  bool inside = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Whole &a = p[i], &b = p[(i + 1) % p.size()];
    if ((2 * a[1] > 2 * q[1] + 1) == (2 * b[1] > 2 * q[1] + 1)) continue;
    // At height q + 1/2, far to the left of nothing: x of the edge there.
    const double y = static_cast<double>(q[1]) + 0.5;
    const double x = static_cast<double>(a[0]) + (y - static_cast<double>(a[1])) *
                                                     static_cast<double>(b[0] - a[0]) /
                                                     static_cast<double>(b[1] - a[1]);
    inside ^= x > static_cast<double>(q[0]);
  }
  return inside;
}

std::vector<Segment> ring(std::size_t n) {
  std::vector<Segment> list;
  for (u32 i = 0; i < n; ++i) list.push_back({i, static_cast<u32>((i + 1) % n)});
  return list;
}

}  // namespace

TEST_CASE("modes polygons: simple ones are found among all on small grids") {
  Random random(kSeed);
  Failures failures;
  std::uint64_t simple = 0, other = 0;
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    const std::size_t n = 2 + random() % 6;
    std::vector<Whole> p(n);
    for (auto& v : p)
      v = {static_cast<std::int64_t>(random() % 5), static_cast<std::int64_t>(random() % 5)};
    // Errors from none to more than distances.
    const double error = std::array{0.0, 1e-9, 0.3, 3.0}[random() % 4];
    const bool expected = naively_simple(p);
    (expected ? simple : other) += 1;
    failures.expect(are_simple(planar(p, error, random), ring(n)) == expected, "simple",
                    static_cast<double>(n), error);
  }
  CHECK(failures.report() == "");
  CHECK(simple > 1000);
  CHECK(other > 1000);
}

TEST_CASE("modes polygons: what a polygon holds") {
  Random random(kSeed);
  Failures failures;
  std::uint64_t inside = 0;
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    const std::size_t n = 3 + random() % 5;
    std::vector<Whole> p(n + 1);
    for (auto& v : p)
      v = {static_cast<std::int64_t>(random() % 9), static_cast<std::int64_t>(random() % 9)};
    const Whole q = p.back();
    std::vector<Whole> polygon(p.begin(), p.end() - 1);
    if (!naively_simple(polygon)) continue;
    bool touches = false;
    for (std::size_t k = 0; k < n; ++k) touches |= on(q, polygon[k], polygon[(k + 1) % n]);
    // The naive ray goes half a step above q: no edge may be between.
    for (std::size_t k = 0; k < n; ++k)
      touches |= meet({2 * q[0], 2 * q[1]}, {2 * q[0], 2 * q[1] + 1},
                      {2 * polygon[k][0], 2 * polygon[k][1]},
                      {2 * polygon[(k + 1) % n][0], 2 * polygon[(k + 1) % n][1]});
    if (touches) continue;
    std::vector<u32> numbers(n);
    for (u32 k = 0; k < n; ++k) numbers[k] = k;
    const bool expected = naively_inside(polygon, q);
    inside += expected;
    const double error = std::array{0.0, 1e-9, 0.3}[random() % 3];
    failures.expect(holds(planar(p, error, random), numbers, static_cast<u32>(n)) == expected,
                    "holds", static_cast<double>(n), error);
  }
  CHECK(failures.report() == "");
  CHECK(inside > 100);
}
