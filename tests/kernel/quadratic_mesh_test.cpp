// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/quadratic_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <map>

#include "kernel/geometry/input_error.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

using Faces = std::vector<Triangle>;
using Midsides = std::vector<std::array<double, 3>>;

std::vector<Vec3> points(std::size_t n) {
  return std::vector<Vec3>(n);  // positions play no part
}

std::string error_of(std::size_t vertices, const Faces& faces, std::vector<double> values,
                     const Midsides& midside = {}) {
  try {
    QuadraticMesh(points(vertices), faces, std::move(values), midside);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}
std::string error_of(std::size_t vertices, const Faces& faces) {
  return error_of(vertices, faces, std::vector<double>(vertices, 1.0));
}

// An n x n torus, or a Klein bottle, each face turned at random and half of them reversed.
Faces grid(Index n, bool klein, Draw& d) {
  Faces faces;
  auto id = [&](Index i, Index j) {
    if (i == n && klein) j = (2 * n - j) % n;
    return (i % n) * n + j % n;
  };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      for (Triangle t : {Triangle{id(i, j), id(i + 1, j), id(i + 1, j + 1)},
                         Triangle{id(i, j), id(i + 1, j + 1), id(i, j + 1)}}) {
        std::rotate(t.begin(), t.begin() + d.integer(0, 2), t.end());
        if (d.coin()) std::swap(t[0], t[1]);
        faces.push_back(t);
      }
  for (std::size_t i = faces.size(); i-- > 1;)
    std::swap(faces[i], faces[static_cast<std::size_t>(d.integer(0, static_cast<int>(i)))]);
  return faces;
}

}  // namespace

TEST_CASE("quadratic mesh: edges as a map of vertex pairs gives them") {
  Draw d(600);
  for (const bool klein : {false, true}) {
    const Faces faces = grid(9, klein, d);
    const QuadraticMesh mesh(points(81), faces, std::vector<double>(81, 0.5));
    std::map<std::pair<Index, Index>, std::vector<Index>> expected;
    for (Index f = 0; f < faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        expected[std::minmax(faces[f][k], faces[f][(k + 1) % 3])].push_back(f);
    REQUIRE(mesh.edge_count() == expected.size());
    Index i = 0;
    for (const auto& [ends, of] : expected) {
      const Edge& e = mesh.edges()[i];
      REQUIRE((e.v0 == ends.first && e.v1 == ends.second));
      REQUIRE((of.size() == 2 && e.f0 == of[0] && e.f1 == of[1]));
      for (Index f : of) {
        const auto& sides = mesh.face_edges()[f];
        const auto k =
            static_cast<std::size_t>(std::find(sides.begin(), sides.end(), i) - sides.begin());
        REQUIRE(k < 3);
        REQUIRE(std::pair<Index, Index>(std::minmax(faces[f][k], faces[f][(k + 1) % 3])) == ends);
      }
      ++i;
    }
    CHECK(mesh.linear());
  }
}

TEST_CASE("quadratic mesh: boundaries, hubs and midside values") {
  const QuadraticMesh one(points(3), {{2, 0, 1}}, {1, 2, 3}, {{5, 6, 7}});
  CHECK(one.edge_count() == 3);
  CHECK(one.edge_values() == std::vector<double>{6, 5, 7});  // 0-1, 0-2, 1-2
  CHECK(one.edges()[0].f1 == kNone);
  // A cone over 100 vertices, closed, then open: vertex 0 is a hub of the bucket sort.
  Faces cone;
  for (Index i = 0; i < 100; ++i) cone.push_back({0, i + 1, (i + 1) % 100 + 1});
  CHECK(QuadraticMesh(points(101), cone, std::vector<double>(101)).edge_count() == 200);
  cone.pop_back();
  std::reverse(cone.begin() + 30, cone.end());
  const QuadraticMesh open(points(101), cone, std::vector<double>(101));
  CHECK(open.edge_count() == 199);
  for (Index i = 0; i < 100; ++i) CHECK(open.edges()[i].v1 == i + 1);
}

TEST_CASE("quadratic mesh: bad input is named in one line") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Faces one = {{0, 1, 2}}, two = {{0, 1, 2}, {1, 3, 2}};
  CHECK(error_of(3, {}) == "mesh: it has no faces; give a triangle mesh");
  CHECK(error_of(3, one, {0, 1}) ==
        "field: it has 2 values for 3 vertices; give one value a vertex");
  CHECK(error_of(3, one, {0, nan, 1}) ==
        "vertex 1: its value is not a finite number; repair the field or remove the vertex");
  CHECK(error_of(3, one, {0, 1, infinity}).rfind("vertex 2:", 0) == 0);
  CHECK(error_of(3, {{0, 1, 3}}) == "face 0: a vertex number is out of range; repair the file");
  CHECK(error_of(3, {{0, 1, 1}}) == "face 0: it repeats a vertex; remove degenerate faces");
  CHECK(error_of(4, one) == "vertex 3: it belongs to no face; remove isolated vertices");
  CHECK(error_of(3, {{0, 1, 2}, {2, 1, 0}}) == "face 1: it duplicates face 0; remove one of them");
  CHECK(error_of(5, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}) ==
        "edge 0-1: it has more than two faces; make the surface a manifold");
  CHECK(error_of(5, {{0, 1, 2}, {0, 3, 4}}) ==
        "vertex 0: several fans of faces meet in it; split it");
  // Two cones tip to tip: two cycles in one link.
  Faces tips;
  for (Index i = 0; i < 3; ++i) {
    tips.push_back({0, 1 + i, 1 + (i + 1) % 3});
    tips.push_back({0, 4 + i, 4 + (i + 1) % 3});
  }
  CHECK(error_of(7, tips) == "vertex 0: several fans of faces meet in it; split it");
  CHECK(error_of(3, one, {0, 1, 2}, {{0, nan, 0}}) ==
        "face 0: a midside value is not a finite number; repair the field");
  CHECK(error_of(4, two, {0, 1, 2, 3}, {{0, 0, 0}}) ==
        "field: it has midside values for 1 of 2 faces; give three values a face");
  CHECK(error_of(4, two, {0, 1, 2, 3}, {{0, 1, 0}, {0, 0, 2}}) ==
        "edge 1-2: faces 0 and 1 have different midside values on it; make the field continuous");
  CHECK(error_of(4, two, {0, 1, 2, 3}, {{0, 1, 0}, {0, 0, 1}}).empty());
  std::vector<Vec3> bad(3);
  bad[2][1] = nan;
  CHECK_THROWS_AS(QuadraticMesh(bad, one, {0, 1, 2}), InputError);
}
