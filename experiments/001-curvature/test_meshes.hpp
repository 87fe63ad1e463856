// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The test meshes of paper 001, section 3.3 (figure 3.4): a torus and a waved tube, each with
// random diagonals ("1") and as a Delaunay triangulation of perturbed parameters ("2"). The thesis'
// second surface is the middle part of Goldfeather and Interrante's test surface ("since the joints
// to the top and bottom parts are not curvature continuous"), whose formula it does not give; the
// waved tube stands in for it: two boundary curves, K of both signs.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "algorithms/curvature/curvature.hpp"

namespace crest::experiments {

using curvature::PointCurvature;
using kernel::Index;
using kernel::Vec3;

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// Position and its partial derivatives; x_u x x_v points outwards.
struct SurfacePoint {
  Vec3 x, u, v, uu, uv, vv;
};
/// u has period 1; v has period 1 or runs from 0 to 1.
struct TestSurface {
  std::string name;
  bool periodic_v;
  std::function<SurfacePoint(double u, double v)> at;
};

/// The torus R = 2, r = 1 (the thesis does not give its radii).
inline TestSurface torus() {
  return {"Torus", true, [](double a, double b) {
            constexpr double w = 2 * std::numbers::pi;
            const double cu = std::cos(w * a), su = std::sin(w * a), cv = std::cos(w * b),
                         sv = std::sin(w * b), rho = 2 + cv;
            return SurfacePoint{{rho * cu, rho * su, sv},
                                {-w * rho * su, w * rho * cu, 0},
                                {-w * sv * cu, -w * sv * su, w * cv},
                                {-w * w * rho * cu, -w * w * rho * su, 0},
                                {w * w * sv * su, -w * w * sv * cu, 0},
                                {-w * w * cv * cu, -w * w * cv * su, -w * w * sv}};
          }};
}

/// Radius r(phi, z) = 1 + 0.15 cos 3 phi cos pi z + 0.2 sin 2 z around the z axis, |z| <= 1.
inline TestSurface waved_tube() {
  return {"Waved tube", false, [](double a, double b) {
            constexpr double w = 2 * std::numbers::pi, pi = std::numbers::pi;
            const double phi = w * a, z = 2 * b - 1;
            const double c3 = std::cos(3 * phi), s3 = std::sin(3 * phi), cz = std::cos(pi * z),
                         sz = std::sin(pi * z);
            const double r = 1 + 0.15 * c3 * cz + 0.2 * std::sin(2 * z);
            const double rp = -0.45 * s3 * cz, rz = -0.15 * pi * c3 * sz + 0.4 * std::cos(2 * z);
            const double rpp = -1.35 * c3 * cz, rpz = 0.45 * pi * s3 * sz;
            const double rzz = -0.15 * pi * pi * c3 * cz - 0.8 * std::sin(2 * z);
            const Vec3 e = {std::cos(phi), std::sin(phi), 0}, t = {-e[1], e[0], 0}, k = {0, 0, 1};
            // phi = w a, z = 2 b - 1.
            return SurfacePoint{r * e + z * k,
                                w * rp * e + w * r * t,
                                2 * rz * e + 2 * k,
                                w * w * (rpp - r) * e + 2 * w * w * rp * t,
                                2 * w * rpz * e + 2 * w * rz * t,
                                4 * rzz * e};
          }};
}

/// Mesh, exact unit normals and curvatures (equations 3.1 to 3.6) at the vertices.
struct TestMesh {
  std::string name;
  std::vector<Vec3> points, normals;
  std::vector<kernel::Triangle> faces;
  std::vector<PointCurvature> exact;
};

inline void add_point(TestMesh& mesh, const SurfacePoint& s) {
  Vec3 n = cross(s.u, s.v);
  n = 1 / norm(n) * n;
  // Orthonormal frame along x_u: II in it is symmetric.
  const double lu = norm(s.u);
  const Vec3 t1 = 1 / lu * s.u, t2 = cross(n, t1);
  const double p = dot(s.v, t1), q = dot(s.v, t2);
  const double e = dot(s.uu, n), f = dot(s.uv, n), g = dot(s.vv, n);
  const double a = e / (lu * lu), b = (f / lu - a * p) / q;
  const double d = (g - 2 * f * p / lu + e * p * p / (lu * lu)) / (q * q);
  const double angle = 0.5 * std::atan2(2 * b, a - d), root = std::hypot(0.5 * (a - d), b);
  PointCurvature c;
  c.H = 0.5 * (a + d);
  c.k1 = c.H + root;
  c.k2 = c.H - root;
  c.K = a * d - b * b;
  c.d1 = std::cos(angle) * t1 + std::sin(angle) * t2;
  c.d2 = -std::sin(angle) * t1 + std::cos(angle) * t2;
  mesh.points.push_back(s.x);
  mesh.normals.push_back(n);
  mesh.exact.push_back(c);
}

/// nu columns around, nv rows (and one more where v is not periodic); each cell's diagonal is a
/// coin's.
inline TestMesh random_diagonals(const TestSurface& surface, int nu, int nv, std::uint64_t seed) {
  TestMesh mesh{surface.name + " 1", {}, {}, {}, {}};
  std::mt19937_64 random(seed);
  const int rows = surface.periodic_v ? nv : nv + 1;
  const auto at = [&](int i, int j) { return static_cast<Index>((j % rows) * nu + i % nu); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < nu; ++i)
      add_point(mesh, surface.at(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (random() % 2 == 0) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      } else {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
    }
  return mesh;
}

/// Grid parameters moved by up to 0.4 of a cell (boundary rows along themselves only), then CGAL's
/// Delaunay triangulation of the parameters, periodic by copies. Parameters are integers, so that
/// copies are exact and a triangle of the period is one whose centroid lies in it.
inline TestMesh perturbed_delaunay(const TestSurface& surface, int nu, int nv, std::uint64_t seed) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Delaunay =
      CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  constexpr std::int64_t kCell = 1 << 20;
  TestMesh mesh{surface.name + " 2", {}, {}, {}, {}};
  std::mt19937_64 random(seed);
  const int rows = surface.periodic_v ? nv : nv + 1;
  const auto jitter = [&] {
    const auto width = static_cast<std::uint64_t>(0.8 * kCell);
    return static_cast<std::int64_t>(random() % width) - static_cast<std::int64_t>(width / 2);
  };
  std::vector<std::pair<Kernel::Point_2, Index>> sites;
  const std::int64_t period_u = nu * kCell, period_v = nv * kCell;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < nu; ++i) {
      const std::int64_t u = i * kCell + jitter();
      const std::int64_t moved = jitter();
      const bool edge = !surface.periodic_v && (j == 0 || j == nv);
      const std::int64_t v = j * kCell + (edge ? 0 : moved);
      const auto index = static_cast<Index>(mesh.points.size());
      add_point(mesh, surface.at(static_cast<double>(u) / static_cast<double>(period_u),
                                 static_cast<double>(v) / static_cast<double>(period_v)));
      for (int cu = -1; cu <= 1; ++cu)
        for (int cv = surface.periodic_v ? -1 : 0; cv <= (surface.periodic_v ? 1 : 0); ++cv) {
          sites.emplace_back(Kernel::Point_2(static_cast<double>(u + cu * period_u),
                                             static_cast<double>(v + cv * period_v)),
                             index);
        }
    }
  Delaunay delaunay;
  delaunay.insert(sites.begin(), sites.end());
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f) {
    double su = 0, sv = 0;
    kernel::Triangle t{};
    for (int k = 0; k < 3; ++k) {
      su += f->vertex(k)->point().x();
      sv += f->vertex(k)->point().y();
      t[static_cast<std::size_t>(k)] = f->vertex(k)->info();
    }
    const bool inside_u = su >= 0 && su < 3 * static_cast<double>(period_u);
    const bool inside_v =
        !surface.periodic_v || (sv >= 0 && sv < 3 * static_cast<double>(period_v));
    if (inside_u && inside_v) mesh.faces.push_back(t);
  }
  return mesh;
}

inline double bounding_diagonal(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  return norm(high - low);
}

/// Along the exact normals by a uniform length in [0, s d / 100].
inline std::vector<Vec3> displaced(const TestMesh& mesh, double s, std::uint64_t seed) {
  std::mt19937_64 random(seed * 1000003 + 17);
  const double length = s / 100 * bounding_diagonal(mesh.points);
  std::vector<Vec3> points = mesh.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = static_cast<double>(random() >> 11) * 0x1p-53;
    points[i] = points[i] + t * length * mesh.normals[i];
  }
  return points;
}

}  // namespace crest::experiments
