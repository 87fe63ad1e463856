// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/mesh_surface.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::sampling {
namespace {

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const std::string& line : list_surfaces())
    names.push_back(line.substr(0, line.find_first_of(" :")));
  REQUIRE(names.back() == "handles");  // has no exact surface: a test of its own
  names.pop_back();
  return names;
}

Real smallest_angle(const SurfaceSample& s) {
  Real least = 4;
  for (const auto& f : s.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point p = to_point(s.points[f[k]]);
      const Point a = to_point(s.points[f[(k + 1) % 3]]) - p;
      const Point b = to_point(s.points[f[(k + 2) % 3]]) - p;
      least = std::min(least, std::atan2(norm(cross(a, b)), dot(a, b)));
    }
  return least;
}

}  // namespace

TEST_CASE("every surface gives a manifold mesh with the known topology") {
  for (const std::string& name : all_names())
    for (const int vertices : {300, 5000}) {
      INFO(name << " " << vertices);
      const SurfaceSample s = sample(name, {}, vertices, true);
      const kernel::TriangleMesh mesh(s.points, s.faces);
      REQUIRE(mesh.euler_characteristic() == s.known.euler_characteristic);
      REQUIRE(static_cast<int>(mesh.boundary_loops()) == s.known.boundary_loops);
      REQUIRE(mesh.components() == 1);
      REQUIRE(s.forms.size() == s.points.size());
      REQUIRE(std::abs(static_cast<double>(s.points.size()) / vertices - 1) < 0.2);
    }
}

TEST_CASE("handles: one closed surface of the genus asked for") {
  for (const int genus : {0, 1, 2, 5})
    for (const int vertices : {40, 5000, 20000}) {
      INFO(genus << " " << vertices);
      const SurfaceSample s = sample("handles", {double(genus)}, vertices, false);
      const kernel::TriangleMesh mesh(s.points, s.faces);
      CHECK(mesh.euler_characteristic() == 2 - 2 * genus);
      CHECK(mesh.boundary_loops() == 0);
      CHECK(mesh.components() == 1);
      if (vertices < 5000) continue;
      CHECK(std::abs(static_cast<double>(s.points.size()) / vertices - 1) < 0.3);
    }
  CHECK_THROWS_AS(sample("handles", {-1}, 100, false), std::invalid_argument);
  CHECK_THROWS_AS(sample("handles", {0.5}, 100, false), std::invalid_argument);
}

TEST_CASE("points lie on the surface, faces look outward and are well shaped") {
  for (const std::string& name : all_names()) {
    INFO(name);
    const Surface surface = make_surface(name, {}, true);
    const SurfaceSample s = sample(surface, 2500, true);
    for (const Vec3& p : s.points) {
      const ValueAndGradient g = surface.gradient(to_point(p));
      REQUIRE(std::abs(g.value) / norm(g.gradient) < 5e-16L * (1 + norm(to_point(p))));
    }
    for (const auto& f : s.faces) {
      const Point a = to_point(s.points[f[0]]), b = to_point(s.points[f[1]]),
                  c = to_point(s.points[f[2]]);
      for (const kernel::Index v : f) REQUIRE(dot(cross(b - a, c - a), to_point(s.forms[v].n)) > 0);
    }
    REQUIRE(smallest_angle(s) > 0.2L);
  }
}

TEST_CASE("star-shaped surfaces are: rays leave them outward") {
  for (const std::string name : {"ellipsoid", "blend", "quartic-sphere", "sphere"}) {
    const Surface surface = make_surface(name, {}, false);
    for (const Vec3& p : sample(surface, 10000, true).points) {
      const Point ray = to_point(p) - surface.centre, g = surface.gradient(to_point(p)).gradient;
      INFO(name);
      REQUIRE(dot(ray, g) > 0.1L * norm(ray) * norm(g));
    }
  }
  for (const std::string name : {"torus", "perturbed-torus"}) {
    const Surface surface = make_surface(name, {}, false);
    for (const Vec3& p : sample(surface, 5000, true).points) {
      const Point ray = to_point(p) - surface.ray_origin(to_point(p));
      const Point g = surface.gradient(to_point(p)).gradient;
      REQUIRE(dot(ray, g) > 0.1L * norm(ray) * norm(g));
    }
  }
}

TEST_CASE("icosahedral meshes have 10 n^2 + 2 vertices") {
  for (const int n : {2, 16, 32})
    REQUIRE(sample("ellipsoid", {}, 10 * n * n + 2, false).points.size() ==
            static_cast<std::size_t>(10 * n * n + 2));
}

TEST_CASE("samples do not depend on threads or on the run") {
  for (const std::string name : {"blend", "perturbed-torus", "umbilic-patch"}) {
    const SurfaceSample a = sample(name, {}, 2000, true);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const SurfaceSample b = sample(name, {}, 2000, true);
    REQUIRE(a.points == b.points);
    REQUIRE(a.faces == b.faces);
    for (std::size_t v = 0; v < a.forms.size(); ++v) {
      REQUIRE(a.forms[v].d1 == b.forms[v].d1);
      REQUIRE(a.forms[v].b0 == b.forms[v].b0);
      REQUIRE(a.forms[v].c4 == b.forms[v].c4);
    }
  }
}

TEST_CASE("noise has the wanted deviation, follows the normals and repeats") {
  const SurfaceSample s = sample("sphere", {}, 10000, true);
  const std::vector<Vec3> along = normals(s);
  std::vector<Vec3> a = s.points, b = s.points, c = s.points, d = s.points;
  add_normal_noise(a, along, 0.01, 7);
  add_normal_noise(b, along, 0.01, 7);
  add_normal_noise(c, along, 0.01, 8);
  add_normal_noise(d, {}, 0.01, 7);
  REQUIRE(a == b);
  REQUIRE(a != c);
  double mean = 0, square = 0, isotropic = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const double r = std::hypot(a[v][0], a[v][1], a[v][2]) - 1;
    mean += r;
    square += r * r;
    REQUIRE(norm(cross(to_point(a[v]), to_point(along[v]))) < 1e-15L);
    for (std::size_t i = 0; i < 3; ++i) isotropic += std::pow(d[v][i] - s.points[v][i], 2);
  }
  const double n = static_cast<double>(a.size());
  REQUIRE(std::abs(mean / n) < 5 * 0.01 / std::sqrt(n));
  REQUIRE(std::sqrt(square / n) == Approx(0.01).epsilon(0.03));
  REQUIRE(std::sqrt(isotropic / (3 * n)) == Approx(0.01).epsilon(0.03));
  REQUIRE_THROWS_AS(add_normal_noise(a, {Vec3{}}, 0.01, 7), std::invalid_argument);
}

TEST_CASE("bad requests are refused") {
  REQUIRE_THROWS_AS(sample("egg", {}, 100, false), std::invalid_argument);
  REQUIRE_THROWS_AS(sample("ellipsoid", {1, 2, 3, 4}, 100, false), std::invalid_argument);
  REQUIRE_THROWS_AS(sample("ellipsoid", {1, -2, 3}, 100, false), std::invalid_argument);
  REQUIRE_THROWS_AS(sample("ellipsoid", {1, std::nan(""), 3}, 100, false), std::invalid_argument);
  REQUIRE_THROWS_AS(sample("torus", {1, 2}, 100, false), std::invalid_argument);
  REQUIRE_THROWS_AS(sample("ellipsoid", {}, 3, false), std::invalid_argument);
}

}  // namespace crest::sampling
