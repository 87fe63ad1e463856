// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes with known curvatures: torus grids, patches, spheres.
#include <cmath>
#include <numbers>

#include "algorithms/curvature/curvature.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

struct Shape {
  kernel::TriangleMesh mesh;
  std::vector<kernel::Vec3> normals;
  std::vector<curvature::PointCurvature> exact;
};

inline curvature::PointCurvature exact_of(double k1, double k2, const kernel::Vec3& d1,
                                          const kernel::Vec3& d2) {
  curvature::PointCurvature c;
  c.k1 = k1;
  c.k2 = k2;
  c.K = k1 * k2;
  c.H = 0.5 * (k1 + k2);
  c.d1 = d1;
  c.d2 = d2;
  return c;
}

/// n x n points of the torus R = 2, r = 1; random diagonals by the seed, none for 0.
inline Shape torus(int n, std::uint64_t seed) {
  Shape s;
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  crest::tests::Random random(seed);
  const auto at = [&](int i, int j) {
    return static_cast<kernel::Index>(((i + n) % n) * n + (j + n) % n);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / n;
      const double rho = 2 + std::cos(v);
      points.push_back({rho * std::cos(u), rho * std::sin(u), std::sin(v)});
      s.normals.push_back({std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)});
      const kernel::Vec3 around = {-std::sin(u), std::cos(u), 0};
      const kernel::Vec3 across = {-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u),
                                   std::cos(v)};
      s.exact.push_back(exact_of(-std::cos(v) / rho, -1, around, across));
      if (seed != 0 && random() % 2 == 0) {
        faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      } else {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  s.mesh = kernel::TriangleMesh(std::move(points), std::move(faces));
  return s;
}

/// (2 n + 1)^2 points of z = f(x, y) over [-half, half]^2; boundary included.
template <class Height>
kernel::TriangleMesh graph(int n, double half, Height&& height) {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  const int side = 2 * n + 1;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double x = half * (i - n) / n, y = half * (j - n) / n;
      points.push_back({x, y, height(x, y)});
      if (i == 0 || j == 0) continue;
      const auto d = static_cast<kernel::Index>(i * side + j);
      const auto a = d - static_cast<kernel::Index>(side) - 1, b = a + 1, c = d - 1;
      faces.push_back({a, c, d});
      faces.push_back({a, d, b});
    }
  }
  return {std::move(points), std::move(faces)};
}

}  // namespace crest::tests
