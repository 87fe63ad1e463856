// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with known curvatures, orders of convergence, bad input, the same bytes for any number
// of threads.
#include "algorithms/curvature/curvature.hpp"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "algorithms/curvature/focal.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/curvature/shapes.hpp"

using namespace crest::curvature;
using crest::kernel::InputError;
using crest::kernel::TriangleMesh;
using crest::tests::graph;
using crest::tests::torus;

namespace {

Options by(Method method) {
  Options o;
  o.method = method;
  return o;
}

double worst(const std::vector<PointCurvature>& a, const std::vector<PointCurvature>& b) {
  double w = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    w = std::max({w, std::abs(a[i].k1 - b[i].k1), std::abs(a[i].k2 - b[i].k2)});
  return w;
}

double order_of(double coarse, double fine) {
  return std::log2(coarse / fine);
}

}  // namespace

TEST_CASE("names of methods go both ways") {
  for (const Method m : kMethods) CHECK(method_of(name_of(m)) == m);
  CHECK_FALSE(method_of("xx"));
  CHECK_FALSE(method_of(""));
}

TEST_CASE("np on a sphere of any triangulation is exact: K = 1/r^2, H = -1/r, no asymmetry") {
  // With n = x / r the normal is a multiple of the position: W is the identity by -1/r.
  const auto sample = crest::sampling::sample("sphere", {}, 642, true);
  const TriangleMesh mesh(sample.points, sample.faces);
  Options o = by(Method::np);
  o.normals = crest::sampling::normals(sample);
  const Result r = estimate(mesh, o);
  const double k = sample.forms[0].k1;
  for (const PointCurvature& c : r.vertices) {
    CHECK(c.H == Approx(k).epsilon(1e-12));
    CHECK(c.K == Approx(k * k).epsilon(1e-12));
    CHECK(c.asymmetry < 1e-10);
  }
  for (const auto& corners : corner_curvatures(mesh, o.normals))
    for (const PointCurvature& c : corners) CHECK(c.H == Approx(k).epsilon(1e-10));
  // Gradients twice as long: the same tensor.
  for (auto& n : o.normals)
    for (double& x : n) x *= 2;
  const Result doubled = estimate(mesh, o);
  for (std::size_t v = 0; v < r.vertices.size(); ++v)
    CHECK(doubled.vertices[v].H == Approx(r.vertices[v].H).epsilon(1e-12));
}

TEST_CASE("a flat mesh has no curvature by any method, boundary and corners included") {
  const TriangleMesh mesh = graph(4, 1, [](double x, double y) { return 0.5 * x - 0.25 * y; });
  for (const Method m : kMethods) {
    Options o = by(m);
    if (m == Method::np) o.normals.assign(mesh.vertex_count(), Vec3{-0.5, 0.25, 1});
    const Result r = estimate(mesh, o);
    INFO(name_of(m));
    CHECK(r.undetermined == 0);
    for (const PointCurvature& c : r.vertices) {
      CHECK(std::abs(c.k1) < 1e-12);
      CHECK(std::abs(c.k2) < 1e-12);
    }
  }
}

TEST_CASE("np on a cylinder: k1 = 0 along the axis at every vertex") {
  const auto sample = crest::sampling::sample("cylinder", {1}, 900, false);
  const TriangleMesh mesh(sample.points, sample.faces);
  Options o = by(Method::np);
  o.normals = crest::sampling::normals(sample);
  const Result r = estimate(mesh, o);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    // det(n0, n1, n2) = 0: all normals are orthogonal to the axis.
    CHECK(std::abs(r.vertices[v].K) < 1e-10);
    CHECK(std::abs(r.vertices[v].k1) < 1e-10);
    CHECK(r.vertices[v].k2 == Approx(-1).epsilon(0.02));
  }
}

TEST_CASE("fits reproduce what lies in their space") {
  // At the centre of a quadratic height function, its normal given.
  const TriangleMesh mesh =
      graph(2, 0.5, [](double x, double y) { return 0.75 * x * x - 0.5 * y * y + 0.25 * x * y; });
  const Index centre = mesh.vertex_count() / 2;
  for (const Method m : {Method::qf, Method::cf, Method::jet}) {
    Options o = by(m);
    for (const Vec3& p : mesh.points())
      o.normals.push_back({-1.5 * p[0] - 0.25 * p[1], p[1] - 0.25 * p[0], 1});
    const PointCurvature c = estimate(mesh, o).vertices[centre];
    INFO(name_of(m));
    // W = (1.5, 0.25; 0.25, -1).
    CHECK(c.H == Approx(0.25).epsilon(1e-10));
    CHECK(c.K == Approx(-1.5625).epsilon(1e-10));
  }
}

TEST_CASE("cf finds the quadratic part of a cubic height function, qf does not") {
  const auto height = [](double x, double y) { return x * x + 0.5 * y * y + x * x * x; };
  const TriangleMesh mesh = graph(2, 0.5, height);
  Options o = by(Method::cf);
  for (const Vec3& p : mesh.points()) o.normals.push_back({-2 * p[0] - 3 * p[0] * p[0], -p[1], 1});
  const Index centre = mesh.vertex_count() / 2;
  const PointCurvature cubic = estimate(mesh, o).vertices[centre];
  CHECK(cubic.k1 == Approx(2).epsilon(1e-10));
  CHECK(cubic.k2 == Approx(1).epsilon(1e-10));
  CHECK(std::abs(cubic.d1[0]) == Approx(1).epsilon(1e-10));
}

TEST_CASE("every method approximates the torus: curvatures, signs, directions") {
  const auto shape = torus(96, 0);
  for (const Method m : kMethods) {
    Options o = by(m);
    if (m == Method::np) o.normals = shape.normals;
    const Result r = estimate(shape.mesh, o);
    const Distances d = distances(r.vertices, shape.exact);
    INFO(name_of(m));
    CHECK(r.undetermined == 0);
    CHECK(std::sqrt(d.H) < 0.02);
    CHECK(std::sqrt(d.K) < 0.04);
    CHECK(d.P < 0.03);
    CHECK(r.vertices[0].k2 == Approx(-1).epsilon(0.02));  // the outer equator is convex
  }
}

TEST_CASE("ne and np converge on a torus with random diagonals (theorem 3.1, i)") {
  // np: every corner of every triangle, at first order at least.
  const auto corner_error = [](int n) {
    const auto shape = torus(n, 7);
    double w = 0;
    const auto corners = corner_curvatures(shape.mesh, shape.normals);
    for (Index f = 0; f < shape.mesh.face_count(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const PointCurvature& e = shape.exact[shape.mesh.faces()[f][k]];
        w = std::max({w, std::abs(corners[f][k].K - e.K), std::abs(corners[f][k].H - e.H)});
      }
    }
    return w;
  };
  const double e32 = corner_error(32), e64 = corner_error(64), e128 = corner_error(128);
  CHECK(order_of(e32, e64) > 0.8);
  CHECK(order_of(e64, e128) > 0.9);
  // The vertex means: np at least first order too.
  const auto vertex_error = [](int n) {
    const auto shape = torus(n, 7);
    Options o = by(Method::np);
    o.normals = shape.normals;
    return worst(estimate(shape.mesh, o).vertices, shape.exact);
  };
  CHECK(order_of(vertex_error(64), vertex_error(128)) > 0.9);
}

TEST_CASE("the jet of degree 4 converges at third order or better on the torus") {
  const auto error = [](int n) {
    const auto shape = torus(n, 7);
    return worst(estimate(shape.mesh, by(Method::jet)).vertices, shape.exact);
  };
  CHECK(order_of(error(48), error(96)) > 2.7);
}

TEST_CASE("K, H and asymmetry do not change under a rigid motion, curvatures scale by 1 / length") {
  const auto shape = torus(24, 3);
  std::vector<Vec3> moved;
  // A rotation by the rational (3, 4, 5) triangle, then scaled by 4.
  for (const Vec3& p : shape.mesh.points()) {
    moved.push_back(
        {4 * (0.6 * p[0] - 0.8 * p[1]) + 3, 4 * (0.8 * p[0] + 0.6 * p[1]) - 1, 4 * p[2]});
  }
  const TriangleMesh other(moved, shape.mesh.faces());
  for (const Method m :
       {Method::ne, Method::cf, Method::qf, Method::qt, Method::jet, Method::normal_cycle}) {
    const Result a = estimate(shape.mesh, by(m)), b = estimate(other, by(m));
    INFO(name_of(m));
    for (std::size_t v = 0; v < a.vertices.size(); ++v) {
      CHECK(4 * b.vertices[v].H == Approx(a.vertices[v].H).margin(1e-8));
      CHECK(16 * b.vertices[v].K == Approx(a.vertices[v].K).margin(1e-8));
    }
  }
}

TEST_CASE("turning the faces over turns the signs over") {
  const auto shape = torus(16, 5);
  auto faces = shape.mesh.faces();
  for (auto& f : faces) std::swap(f[1], f[2]);
  const TriangleMesh inside(shape.mesh.points(), faces);
  for (const Method m : {Method::ne, Method::cf, Method::qf, Method::qt, Method::normal_cycle}) {
    const Result a = estimate(shape.mesh, by(m)), b = estimate(inside, by(m));
    INFO(name_of(m));
    for (std::size_t v = 0; v < a.vertices.size(); ++v) {
      CHECK(b.vertices[v].k1 == Approx(-a.vertices[v].k2).margin(1e-9));
      CHECK(b.vertices[v].k2 == Approx(-a.vertices[v].k1).margin(1e-9));
    }
  }
}

TEST_CASE("the same bytes for any number of threads") {
  const auto shape = torus(40, 11);
  for (const Method m : kMethods) {
    Options o = by(m);
    if (m == Method::np) o.normals = shape.normals;
    std::vector<std::vector<PointCurvature>> runs;
    for (const std::size_t threads : {1, 2, 5}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      runs.push_back(estimate(shape.mesh, o).vertices);
    }
    // Storage that held something else.
    Result again = estimate(torus(50, 3).mesh, by(Method::ne));
    estimate(shape.mesh, o, again);
    runs.push_back(again.vertices);
    INFO(name_of(m));
    for (const auto& run : runs) {
      REQUIRE(run.size() == runs[0].size());
      CHECK(std::memcmp(run.data(), runs[0].data(), run.size() * sizeof(PointCurvature)) == 0);
    }
  }
}

TEST_CASE("the smallest meshes have finite estimates by every method") {
  const TriangleMesh single({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const TriangleMesh solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  for (const TriangleMesh* mesh : {&single, &solid}) {
    for (const Method m : kMethods) {
      Options o = by(m);
      if (m == Method::np) o.normals = area_weighted_normals(*mesh);
      INFO(name_of(m));
      for (const PointCurvature& c : estimate(*mesh, o).vertices)
        CHECK(std::isfinite(c.k1 + c.k2 + c.K + c.H + c.d1[0] + c.d2[0]));
    }
  }
}

TEST_CASE("bad input is refused in one line that names the element") {
  const auto shape = torus(8, 0);
  const auto message = [](const TriangleMesh& mesh, const Options& o) -> std::string {
    try {
      estimate(mesh, o);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message(shape.mesh, by(Method::np)).find("np needs them") != std::string::npos);
  Options o = by(Method::np);
  o.normals.assign(3, Vec3{0, 0, 1});
  CHECK(message(shape.mesh, o).find("3 for 64") != std::string::npos);
  o.normals = shape.normals;
  o.normals[5] = {0, 0, 0};
  CHECK(message(shape.mesh, o).find("vertex 5") != std::string::npos);
  o.normals[5] = {0, std::nan(""), 1};
  CHECK(message(shape.mesh, o).find("vertex 5") != std::string::npos);
  CHECK(
      message(TriangleMesh({{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}, {{0, 1, 2}}), by(Method::ne))
          .find("scale the mesh by 1e-200") != std::string::npos);
  CHECK(message(TriangleMesh(), by(Method::ne)) != "");
}

TEST_CASE("distances are those of section 3.3") {
  std::vector<PointCurvature> a(2), b(2);
  a[0] = crest::tests::exact_of(2, 1, {1, 0, 0}, {0, 1, 0});
  b[0] = crest::tests::exact_of(1, 1, {0, 1, 0}, {-1, 0, 0});  // exchanged and turned: angle 0
  a[1] = crest::tests::exact_of(1, 0, {1, 0, 0}, {0, 1, 0});
  b[1] = crest::tests::exact_of(1, 0, {0.6, 0.8, 0}, {-0.8, 0.6, 0});
  const Distances d = distances(a, b);
  CHECK(d.K == Approx(0.5));
  CHECK(d.H == Approx(0.125));
  // The smaller of acos 0.6 and acos 0.8, over two vertices.
  CHECK(d.P == Approx(0.5 * std::acos(0.8)));
}

TEST_CASE("focal surfaces stand off by |H| and |K| along the normal") {
  const auto shape = torus(12, 0);
  for (const auto q : {Quantity::gaussian, Quantity::mean}) {
    const FocalSurface s = focal_of_triangles(shape.mesh, shape.normals, q, 0.1, 3);
    CHECK(s.points.size() == 10 * shape.mesh.face_count());
    CHECK(s.triangles.size() == 9 * shape.mesh.face_count());
    CHECK(s.curves.size() == shape.mesh.face_count());
    CHECK(s.curves[0].size() == 10);
    CHECK(s.curves[0].front() == s.curves[0].back());
    // The first lattice point of a face is its first corner.
    const auto corners = corner_curvatures(shape.mesh, shape.normals);
    for (Index f = 0; f < shape.mesh.face_count(); f += 7) {
      const Index v = shape.mesh.faces()[f][0];
      const Vec3 &p = shape.mesh.points()[v], &n = shape.normals[v], &x = s.points[10 * f];
      const double value = value_of(corners[f][0], q);
      CHECK(s.values[10 * f] == Approx(value).margin(1e-9));
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(x[k] == Approx(p[k] + s.scale * std::abs(value) * n[k]).margin(1e-9));
    }
    const Result r = estimate(shape.mesh, by(Method::cf));
    const FocalSurface averaged = focal_of_vertices(shape.mesh, r, q, 0.1);
    CHECK(averaged.points.size() == 3 * shape.mesh.face_count());
    CHECK(averaged.triangles.size() == shape.mesh.face_count());
  }
}
