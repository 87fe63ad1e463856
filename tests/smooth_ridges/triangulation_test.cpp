// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/triangulation.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "algorithms/smooth_ridges/initial_mesh.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "tests/smooth_ridges/samples.hpp"
#include "tests/support/random.hpp"

namespace crest::smooth_ridges {
namespace {

using kernel::Rational;
using Pair = std::pair<Index, Index>;

/// Each directed edge once; its neighbours, and what they say of each other.
void require_conforming(const Triangulation& mesh) {
  std::map<Pair, Index> directed;
  for (Index f = 0; f < mesh.faces().size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      REQUIRE(directed.emplace(Pair{mesh.faces()[f][k], mesh.faces()[f][(k + 1) % 3]}, f).second);
  for (const auto& [edge, f] : directed) {
    const auto back = directed.find({edge.second, edge.first});
    const Index across = back == directed.end() ? kNone : back->second;
    const std::size_t k = mesh.faces()[f][0] == edge.first   ? 0
                          : mesh.faces()[f][1] == edge.first ? 1
                                                             : 2;
    REQUIRE(mesh.neighbours()[f][k] == across);
    if (across != kNone) REQUIRE(mesh.neighbours()[across][mesh.edge_towards(across, f)] == f);
    if (across == kNone || mesh.is_implicit()) continue;
    // The lift difference of an edge's ends is the same in both faces.
    const std::size_t j = mesh.edge_towards(across, f);
    const Vertex a = mesh.corner(f, k), b = mesh.corner(f, (k + 1) % 3);
    const Vertex c = mesh.corner(across, (j + 1) % 3), d = mesh.corner(across, j);
    for (std::size_t i = 0; i < 2; ++i) REQUIRE(b[i] - a[i] == d[i] - c[i]);
  }
}

Rational twice_area(const Triangulation& mesh, Index f) {
  const auto c = mesh.corners(f);
  const auto at = [&](std::size_t k, std::size_t i) {
    return Rational(c[k][i]) - Rational(c[0][i]);
  };
  return at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0);
}

Rational total_area(const Triangulation& mesh) {
  Rational sum = 0;
  for (Index f = 0; f < mesh.faces().size(); ++f) {
    const Rational area = twice_area(mesh, f);
    REQUIRE(area > 0);
    sum += area;
  }
  return sum / 2;
}

std::vector<Index> random_faces(const Triangulation& mesh, crest::tests::Random& random) {
  std::vector<Index> marked;
  for (int i = 0; i < 40; ++i) marked.push_back(static_cast<Index>(random() % mesh.faces().size()));
  // Refinement that runs into one point.
  marked.push_back(static_cast<Index>(mesh.faces().size() - 1));
  return marked;
}

}  // namespace

TEST_CASE("random refinement keeps parametric triangulations exact") {
  crest::tests::Random random(1);
  for (const Surface& s : {parametric_torus(), parametric_tube(), parametric_patch()}) {
    Triangulation mesh = initial_mesh(s, 200);
    const int chi = mesh.euler_characteristic();
    CHECK(chi == (s.any_period() ? 0 : 1));
    require_conforming(mesh);
    CHECK(total_area(mesh) == 1);
    for (int round = 0; round < 12; ++round) mesh.refine(random_faces(mesh, random));
    require_conforming(mesh);
    CHECK(total_area(mesh) == 1);
    CHECK(mesh.euler_characteristic() == chi);
    for (const Vertex& v : mesh.vertices())
      for (std::size_t i = 0; i < 2; ++i) {
        REQUIRE(v[i] >= 0);
        REQUIRE((s.periodic(i) ? v[i] < 1 : v[i] <= 1));
      }
  }
}

TEST_CASE("random refinement keeps closed triangulations closed") {
  crest::tests::Random random(2);
  for (const Sample& sample : closed_samples()) {
    INFO(sample.name);
    Triangulation mesh = initial_mesh(sample.surface, 600);
    Projection f(sample.surface);
    for (int round = 0; round < 8; ++round) mesh.refine(random_faces(mesh, random));
    require_conforming(mesh);
    for (const auto& around : mesh.neighbours())
      for (const Index n : around) REQUIRE(n != kNone);
    CHECK(mesh.euler_characteristic() == sample.euler_characteristic);
    for (const Vertex& v : mesh.vertices()) {
      const Projection::Sample at = f.sample(position(v));
      REQUIRE(std::fabs(at.value) <= 1e-14 * (1 + length(at.gradient)));
      REQUIRE(dot(normal(v), at.gradient) == Approx(length(at.gradient)));
    }
  }
}

TEST_CASE("every marked face is bisected and only changed faces get new ids") {
  Triangulation mesh = initial_mesh(parametric_torus(), 300);
  const std::vector<Triangle> faces = mesh.faces();
  const std::vector<std::uint64_t> ids = mesh.ids();
  const std::uint64_t mark = mesh.next_id();
  const std::vector<Index> marked = {0, 17, 17, 100};
  mesh.refine(marked);
  for (const Index f : marked) CHECK(mesh.ids()[f] >= mark);
  std::size_t kept = 0;
  for (Index f = 0; f < faces.size(); ++f) {
    CHECK((mesh.ids()[f] == ids[f]) == (mesh.faces()[f] == faces[f]));
    kept += mesh.ids()[f] == ids[f] ? 1 : 0;
  }
  CHECK(kept > faces.size() / 2);
  for (Index f = static_cast<Index>(faces.size()); f < mesh.faces().size(); ++f)
    CHECK(mesh.ids()[f] >= mark);
  const std::set<std::uint64_t> distinct(mesh.ids().begin(), mesh.ids().end());
  CHECK(distinct.size() == mesh.faces().size());
}

TEST_CASE("refinement does not let angles degenerate") {
  // Rivara 1984: bisecting longest edges at most halves the least angle.
  const Sample sample = closed_samples()[0];
  Triangulation mesh = initial_mesh(sample.surface, 300);
  const auto least_angle = [&] {
    double least = 4;
    for (Index f = 0; f < mesh.faces().size(); ++f) {
      const auto c = mesh.corners(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 a = step(position(c[(k + 1) % 3]), -1, position(c[k]));
        const Vec3 b = step(position(c[(k + 2) % 3]), -1, position(c[k]));
        least = std::min(least, std::atan2(length(cross(a, b)), dot(a, b)));
      }
    }
    return least;
  };
  const double before = least_angle();
  // Around one vertex, as the driver does around an umbilic.
  for (int round = 0; round < 20; ++round) {
    std::vector<Index> marked;
    for (Index f = 0; f < mesh.faces().size(); ++f)
      for (const Index v : mesh.faces()[f])
        if (v == 0) marked.push_back(f);
    mesh.refine(marked);
  }
  CHECK(mesh.faces().size() < 2000);
  CHECK(least_angle() > 0.4 * before);
}

TEST_CASE("edges of three faces, and turned faces, are refused") {
  const std::vector<Vertex> points(5);
  const EdgeRules rules{[](const Vertex&, const Vertex&) { return 1.0; }, {}, {}};
  CHECK_THROWS_AS(Triangulation(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}, rules),
                  std::invalid_argument);
  CHECK_THROWS_AS(Triangulation(points, {{0, 1, 2}, {0, 1, 3}}, {}, rules), std::invalid_argument);
}

}  // namespace crest::smooth_ridges
