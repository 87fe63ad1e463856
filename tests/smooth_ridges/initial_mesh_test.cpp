// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/initial_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "algorithms/smooth_ridges/surface_net.hpp"
#include "tests/smooth_ridges/samples.hpp"
#include "tests/support/random.hpp"

namespace crest::smooth_ridges {
namespace {

MeshError::Reason reason_of(const Surface& s) {
  try {
    initial_mesh(s, 500);
  } catch (const MeshError& error) {
    return error.reason();
  }
  FAIL("a mesh was made");
  return MeshError::Reason::rough;
}

}  // namespace

TEST_CASE("start meshes have the surface's topology and face outward") {
  for (const Sample& sample : closed_samples())
    for (const int target : {400, 3000}) {
      INFO(sample.name << " " << target);
      const Triangulation mesh = initial_mesh(sample.surface, target);
      CHECK(mesh.euler_characteristic() == sample.euler_characteristic);
      const auto component = mesh.face_components();
      CHECK(std::set<Index>(component.begin(), component.end()).size() == sample.components);
      CHECK(static_cast<double>(mesh.faces().size()) > 0.7 * target);
      for (Index f = 0; f < mesh.faces().size(); ++f) {
        const auto c = mesh.corners(f);
        const Vec3 flat = cross(position(c[1]) - position(c[0]), position(c[2]) - position(c[0]));
        for (const Vertex& v : c) REQUIRE(dot(flat, normal(v)) > 0.4 * norm(flat));
      }
    }
}

TEST_CASE("a small component is meshed when a point of it is known") {
  const Surface s =
      Surface::implicit("(x^2+y^2+z^2-1) * ((x-2)^2+y^2+z^2-0.01)", {-3.1, 3, -3.1, 3, -3.1, 3});
  const Triangulation mesh = initial_mesh(s, 400, {{{{2.1, 0, 0}, 0}}, {}});
  CHECK(mesh.euler_characteristic() == 4);
}

TEST_CASE("a component of a thousandth is meshed by smaller cells there, not everywhere") {
  for (const double r : {1e-2, 1e-3, 1e-4}) {
    INFO(r);
    const std::string f = "(x^2+y^2/2.25+z^2/4-1) * ((x-2.4)^2+(y-0.3)^2+(z-0.2)^2-" +
                          std::to_string(1e8 * r * r) + "e-8)";
    const Surface s = Surface::implicit(f, {-3, 3, -3, 3, -3, 3});
    const Triangulation mesh = initial_mesh(s, 600, {{{{2.4 + r, 0.3, 0.2}, 0.3 * r}}, {}});
    CHECK(mesh.euler_characteristic() == 4);
    CHECK(mesh.faces().size() < 1500);
    const Triangulation again = initial_mesh(s, 600, {{{{2.4 + r, 0.3, 0.2}, 0.3 * r}}, {}});
    CHECK(mesh.faces() == again.faces());
  }
}

TEST_CASE("a net on a graded grid is a closed surface, wherever its cells are small") {
  crest::tests::Random random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const Sample& sample : closed_samples()) {
    INFO(sample.name);
    if (sample.name == "genus 2") continue;  // thinner than these cells
    Projection f(sample.surface);
    const Triangulation mesh = initial_mesh(sample.surface, 400);
    for (int round = 0; round < 10; ++round) {
      std::vector<FineSpot> spots;
      for (int i = 0; i < 3; ++i) {
        const Vertex& v = mesh.vertices()[random() % mesh.vertices().size()];
        spots.push_back({position(v), std::exp2(between(-9, -3))});
      }
      const Grid grid = generic_grid({-4, -4, -4}, {4, 4, 4}, 0.11);
      const SurfaceNet net = surface_net(f, sample.surface.box(), grid, spots);
      REQUIRE_FALSE(net.on_boundary);
      REQUIRE(net.cells.size() == net.points.size());
      CHECK(*std::min_element(net.cells.begin(), net.cells.end()) < 0.11);
      std::vector<Vertex> vertices;
      for (const Vec3& p : net.points) vertices.push_back({p[0], p[1], p[2], 0, 0, 1});
      const Triangulation closed(vertices, net.faces, {}, edge_rules(sample.surface));
      for (const auto& around : closed.neighbours())
        REQUIRE(std::count(around.begin(), around.end(), kNone) == 0);
      CHECK(closed.euler_characteristic() == sample.euler_characteristic);
    }
  }
}

TEST_CASE("what cannot be meshed is refused with its reason") {
  const Surface::Box box = {-3, 3, -3, 3, -3, 3};
  CHECK(reason_of(Surface::implicit("x^2+y^2+z^2+1", box)) == MeshError::Reason::empty);
  CHECK(reason_of(Surface::implicit("x^2+y^2-1", box)) == MeshError::Reason::boundary);
  CHECK(reason_of(Surface::implicit("x^2+y^2-z^2", box)) == MeshError::Reason::boundary);
  CHECK_THROWS_AS(initial_mesh(parametric_torus(), 3), std::invalid_argument);
}

TEST_CASE("grids are near square in space") {
  // Ten times as long as the circle's radius: 2 pi to 10.
  const Triangulation mesh = initial_mesh(parametric_tube(), 2000);
  CHECK(mesh.faces().size() == Approx(2000).epsilon(0.1));
  std::set<double> at_end;
  for (const Vertex& v : mesh.vertices())
    if (v[1] == 0) at_end.insert(v[0]);
  CHECK(static_cast<double>(at_end.size()) == Approx(std::sqrt(1000 * 6.283 / 10)).epsilon(0.1));
}

TEST_CASE("no vertex of a start mesh lies on a plane of symmetry") {
  const Triangulation mesh = initial_mesh(closed_samples()[0].surface, 2000);
  for (const Vertex& v : mesh.vertices())
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::fabs(v[k]) > 1e-9);
  const Triangulation torus = initial_mesh(parametric_torus(), 2000);
  for (const Vertex& v : torus.vertices())
    for (std::size_t k = 0; k < 2; ++k) {
      const double eighths = 8 * v[k];
      CHECK(std::fabs(eighths - std::round(eighths)) > 1e-9);
    }
}

TEST_CASE("start meshes are the same each time") {
  const Surface s = closed_samples()[1].surface;
  const Triangulation a = initial_mesh(s, 700), b = initial_mesh(s, 700);
  CHECK(a.vertices() == b.vertices());
  CHECK(a.faces() == b.faces());
}

TEST_CASE("periods are proven, not believed") {
  const auto wave = [](const std::string& x, const std::string& u1) {
    return Surface::parametric({x, "sin(u)", "v"}, {"0", u1, "0", "1"}, {true, false});
  };
  CHECK_NOTHROW(wave("cos(u)", "2*pi"));
  CHECK_NOTHROW(wave("cos(3*u + v)/(2 + sin(u))", "4*pi"));
  CHECK_NOTHROW(wave("cos(u - 2*u)^2 * exp(sin(2*u))", "2*pi"));
  CHECK_NOTHROW(wave("u - u", "2*pi"));
  CHECK_THROWS_AS(wave("cos(u)", "pi"), std::invalid_argument);
  CHECK_THROWS_AS(wave("cos(u/2)", "2*pi"), std::invalid_argument);
  CHECK_THROWS_AS(wave("cos(u)", "6.283185307179586"), std::invalid_argument);
  CHECK_THROWS_AS(wave("cos(pi*u)", "2*pi"), std::invalid_argument);
  CHECK_THROWS_AS(wave("u", "2*pi"), std::invalid_argument);
  CHECK_THROWS_AS(wave("cos(u*u)", "2*pi"), std::invalid_argument);
  CHECK_THROWS_AS(wave("cos(u)", "-2*pi"), std::invalid_argument);
}

TEST_CASE("bad surfaces are refused in one line") {
  CHECK_THROWS_AS(Surface::implicit("x +", {0, 1, 0, 1, 0, 1}), kernel::ExpressionError);
  CHECK_THROWS_AS(Surface::implicit("x + u", {0, 1, 0, 1, 0, 1}), kernel::ExpressionError);
  CHECK_THROWS_AS(Surface::implicit("x", {0, 1, 1, 1, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Surface::implicit("x", {0, HUGE_VAL, 0, 1, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Surface::parametric({"u", "v", "0"}, {"0", "0", "0", "1"}, {}),
                  std::invalid_argument);
  CHECK_THROWS_WITH(Surface::parametric({"u", "v", "w"}, {"0", "1", "0", "1"}, {}),
                    Catch::Matchers::Contains("(in z = w)"));
}

}  // namespace crest::smooth_ridges
