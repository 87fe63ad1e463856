// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric fields on an aligned grid, whose separatrices run along edges and through vertices;
// walls; regions without flow.
#include <catch2/catch.hpp>
#include <functional>

#include "algorithms/vector_fields/vector_fields.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

/// On the square from -1 to 1, in cells of 1/4.
PlanarField sampled(const std::function<Vec2(double, double)>& v) {
  PlanarField field = field_of(sampling::lattice_field(1, 8));
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    for (double& x : field.points[i]) x = 2 * x - 1;
    field.vectors[i] = v(field.points[i][0], field.points[i][1]);
  }
  return field;
}

int ends(const Skeleton& s, EndKind end) {
  return static_cast<int>(std::count_if(s.separatrices.begin(), s.separatrices.end(),
                                        [&](const Separatrix& l) { return l.end == end; }));
}

}  // namespace

TEST_CASE("Saddles on an aligned grid: four separatrices to the boundary, none undecided") {
  const std::function<Vec2(double, double)> fields[] = {[](double x, double y) {
                                                          return Vec2{x, -y};
                                                        },
                                                        [](double x, double y) {
                                                          return Vec2{y, x};
                                                        },
                                                        [](double x, double y) {
                                                          return Vec2{-y, -x};
                                                        },
                                                        [](double x, double y) {
                                                          return Vec2{x - 0.0625, 0.03125 - y};
                                                        },
                                                        [](double x, double y) {
                                                          return Vec2{2 * x - 0.3, 0.13 - y};
                                                        }};
  for (const auto& v : fields) {
    const Skeleton s = extract_skeleton(sampled(v));
    REQUIRE(s.critical_points.size() == 1);
    CHECK(s.critical_points[0].kind == ZeroKind::saddle);
    CHECK(s.critical_points[0].index == -1);
    REQUIRE(s.separatrices.size() == 4);
    CHECK(ends(s, EndKind::boundary) == 4);
  }
}

TEST_CASE("A separatrix along edges from saddle to saddle is found") {
  const Skeleton s = extract_skeleton(sampled([](double x, double y) {
    return Vec2{x * x - 0.25, -2 * x * y};
  }));
  REQUIRE(s.critical_points.size() == 2);
  CHECK(s.separatrices.size() == 8);
  CHECK(ends(s, EndKind::critical_point) == 2);
  CHECK(ends(s, EndKind::boundary) == 6);
}

TEST_CASE(
    "Flows without zeros: uniform ones along edges have two switch runs, touched from outside") {
  for (const Vec2& v : {Vec2{1, 0}, Vec2{0, -1}, Vec2{1, 1}}) {
    const Skeleton s = extract_skeleton(sampled([&](double, double) { return v; }));
    CHECK(s.critical_points.empty());
    CHECK(s.separatrices.empty());
    REQUIRE(s.switch_points.size() == 2);
    CHECK_FALSE(s.switch_points[0].inside);
    CHECK(s.index_sum == 0);
  }
}

TEST_CASE("A shear is cut along its line of zeros") {
  const Skeleton s = extract_skeleton(sampled([](double, double y) { return Vec2{y, 0}; }));
  CHECK(s.zero_edges == 8);
  CHECK(s.loops.size() == 2);
  REQUIRE(s.critical_points.size() == 2);
  for (const CriticalPoint& c : s.critical_points) {
    CHECK(c.where == ZeroPlace::line);
    CHECK_FALSE(c.index);
  }
  CHECK(s.winding_sum == 0);
}

TEST_CASE("A region without flow is left out and named, lines end at its walls") {
  const auto field = sampled([](double x, double y) {
    const double r = std::fmax(0.0, std::fmax(std::fabs(x), std::fabs(y)) - 0.3);
    return Vec2{-r * (x + 0.1 * y), -r * (y - 0.2 * x)};
  });
  const Skeleton s = extract_skeleton(field);
  CHECK(s.zero_triangles == 8);
  CHECK(s.zero_regions == 1);
  REQUIRE(s.critical_points.size() == 1);
  CHECK(s.critical_points[0].where == ZeroPlace::region);
  CHECK(s.index_sum == s.winding_sum);
  CHECK(s.loops.size() == 2);
}
