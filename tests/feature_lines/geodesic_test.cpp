// SPDX-License-Identifier: GPL-3.0-or-later
// Fast marching against known distances: in a plane, on a sphere, over obtuse triangles.
#include "algorithms/feature_lines/geodesic.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/feature_lines/meshes.hpp"
#include "tests/support/environment.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;
using Kind = fl::Neighbourhood;

namespace {

Marks only(const TriangleMesh& mesh, Index v) {
  Marks marks(mesh.vertex_count(), 0);
  marks[v] = 1;
  return marks;
}

double length(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The grid of 2 n x 2 n squares over [-1, 1]^2, x moved by `shear` y: obtuse for shear > 0.
TriangleMesh sheet(Index n, double shear) {
  const TriangleMesh base = grid(2 * n, 2 * n);
  std::vector<Vec3> points;
  for (const Vec3& p : base.points()) {
    const double x = p[0] / n - 1, y = p[1] / n - 1;
    points.push_back({x + shear * y, y, 0});
  }
  return TriangleMesh(points, base.faces());
}

/// The octahedron with its faces split `rounds` times, on the unit sphere. Vertex 0: (0, 0, 1).
TriangleMesh sphere(int rounds) {
  std::vector<Vec3> points = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::vector<Triangle> faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                 {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
  for (int round = 0; round < rounds; ++round) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [at, fresh] = middles.emplace(std::minmax(a, b), Index(points.size()));
      if (fresh) {
        Vec3 m{};
        for (std::size_t k = 0; k < 3; ++k) m[k] = points[a][k] + points[b][k];
        const double l = length(m, {0, 0, 0});
        points.push_back({m[0] / l, m[1] / l, m[2] / l});
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& f : faces) {
      const Index a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
    }
    faces = finer;
  }
  return TriangleMesh(points, faces);
}

/// Largest error against `exact`.
template <class Exact>
double worst(const TriangleMesh& mesh, const std::vector<double>& found, Exact&& exact) {
  double error = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    error = std::max(error, std::abs(found[v] - exact(mesh.points()[v])));
  return error;
}

}  // namespace

TEST_CASE("geodesic distance from a straight line in a plane is exact") {
  for (const double shear : {0.0, 0.4, 1.5, -2.5}) {
    const TriangleMesh mesh = sheet(12, shear);
    Marks line(mesh.vertex_count(), 0);
    for (Index v = 0; v < mesh.vertex_count(); ++v) line[v] = mesh.points()[v][1] == 0 ? 1 : 0;
    REQUIRE(fl::count(line) == 25);
    const auto found = fl::geodesic_distances(mesh, line);
    // Far from the sheet's slanted ends, where the nearest point is an end of the line.
    double error = 0;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Vec3& p = mesh.points()[v];
      if (std::abs(p[0]) > 0.5 || std::abs(p[1]) > 0.5) continue;
      error = std::max(error, std::abs(found[v] - std::abs(p[1])));
    }
    INFO("shear " << shear);
    CHECK(error < 1e-12);
  }
}

TEST_CASE("geodesic distance from a point in a plane: from above, and better on a finer grid") {
  // Sheared by 2.5 a third of the corners exceed 150 degrees.
  for (const double shear : {0.0, 0.7, 2.5}) {
    double before = 0;
    for (const Index n : {10u, 20u, 40u}) {
      const TriangleMesh mesh = sheet(n, shear);
      const Index centre = n + (2 * n + 1) * n;
      const Vec3 origin = mesh.points()[centre];
      const auto found = fl::geodesic_distances(mesh, only(mesh, centre));
      bool above = true;
      for (Index v = 0; v < mesh.vertex_count(); ++v)
        above = above && found[v] >= length(origin, mesh.points()[v]) - 1e-12;
      CHECK(above);
      const double error = worst(mesh, found, [&](const Vec3& p) { return length(origin, p); });
      INFO("shear " << shear << ", n " << n << ", error " << error << " before " << before);
      CHECK(error < (1 + shear) * 0.6 / std::sqrt(double(n)));
      if (n > 10) CHECK(error < 0.75 * before);
      before = error;
    }
  }
}

TEST_CASE("geodesic distance on a sphere is the angle, to first order") {
  double before = 0;
  for (const int rounds : {4, 5, 6}) {
    const TriangleMesh mesh = sphere(rounds);
    const auto found = fl::geodesic_distances(mesh, only(mesh, 0));
    const double error =
        worst(mesh, found, [](const Vec3& p) { return std::acos(std::clamp(p[2], -1.0, 1.0)); });
    INFO("rounds " << rounds << ", error " << error);
    if (rounds > 4) CHECK(error < 0.72 * before);
    before = error;
  }
  CHECK(before < 0.03);
}

TEST_CASE("geodesic distances are at most edge paths, stop at the limit, ignore unmarked meshes") {
  Random random(kSeed + 40);
  for (const auto& [name, mesh] : sample_meshes()) {
    const Marks marks = random_marks(mesh, random, 0.03, 0);
    const auto all = fl::geodesic_distances(mesh, marks);
    const auto near = fl::geodesic_distances(mesh, marks, 1.5);
    const Marks path = fl::dilate(mesh, marks, {Kind::path, 1.5});
    INFO(name);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      CHECK((all[v] == 0) == (marks[v] != 0));
      CHECK(near[v] == (all[v] <= 1.5 ? all[v] : HUGE_VAL));
      CHECK((!path[v] || near[v] <= 1.5));
    }
    for (const double d : fl::geodesic_distances(mesh, Marks(mesh.vertex_count(), 0)))
      CHECK(d == HUGE_VAL);
  }
}

TEST_CASE("geodesic operators: nested, dual, with the counts of a disk") {
  const TriangleMesh mesh = grid(40, 40);
  const Index centre = 20 + 41 * 20;
  const Marks disk = fl::dilate(mesh, only(mesh, centre), {Kind::geodesic, 10});
  // A disk of radius 10 has 317 lattice points; distances from one point err by up to an edge.
  CHECK(fl::count(disk) <= 317);
  CHECK(fl::count(disk) > 255);
  CHECK(fl::count(disk) > fl::count(fl::dilate(mesh, only(mesh, centre), {Kind::path, 10})));
  Random random(kSeed + 41);
  for (const auto& [name, sample] : sample_meshes()) {
    const fl::Structure s{Kind::geodesic, 1.3};
    const Marks marks = random_marks(sample, random, 0.1, 1);
    Marks turned = marks;
    for (auto& m : turned) m ^= 1;
    Marks dual = fl::dilate(sample, turned, s);
    for (auto& m : dual) m ^= 1;
    INFO(name);
    CHECK(fl::erode(sample, marks, s) == dual);
    const Marks opened = fl::opening(sample, marks, s), closed = fl::closing(sample, marks, s);
    for (Index v = 0; v < sample.vertex_count(); ++v) {
      CHECK(opened[v] <= marks[v]);
      CHECK(marks[v] <= closed[v]);
    }
  }
}
