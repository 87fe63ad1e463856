// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/curvature/focal.hpp"

#include <algorithm>

#include "algorithms/curvature/methods.hpp"
#include "algorithms/curvature/tangent.hpp"

namespace crest::curvature {
namespace {

constexpr double kQuantile = 0.95;

double diagonal(const kernel::TriangleMesh& mesh) {
  Vec3 low = mesh.points().front(), high = low;
  for (const Vec3& p : mesh.points()) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return norm(high - low);
}

/// Points of a triangle by rows of descending first coordinate: steps + 1 points a side.
std::vector<std::array<double, 3>> lattice(int steps) {
  std::vector<std::array<double, 3>> points;
  for (int row = 0; row <= steps; ++row) {
    for (int i = 0; i <= row; ++i) {
      points.push_back({static_cast<double>(steps - row) / steps,
                        static_cast<double>(row - i) / steps, static_cast<double>(i) / steps});
    }
  }
  return points;
}

Index at(int row, int i) {
  return static_cast<Index>(row * (row + 1) / 2 + i);
}

/// Triangles and boundary of one face's lattice, whose points start at `base`.
void add_face(FocalSurface& s, Index face, Index base, int steps) {
  for (int row = 0; row < steps; ++row) {
    for (int i = 0; i <= row; ++i) {
      s.triangles.push_back({base + at(row, i), base + at(row + 1, i), base + at(row + 1, i + 1)});
      s.faces.push_back(face);
      if (i == row) continue;
      s.triangles.push_back({base + at(row, i), base + at(row + 1, i + 1), base + at(row, i + 1)});
      s.faces.push_back(face);
    }
  }
  std::vector<Index> curve;
  for (int row = 0; row < steps; ++row) curve.push_back(base + at(row, 0));
  for (int i = 0; i < steps; ++i) curve.push_back(base + at(steps, i));
  for (int row = steps; row > 0; --row) curve.push_back(base + at(row, row));
  curve.push_back(base);
  s.curves.push_back(std::move(curve));
}

void displace(FocalSurface& s, const std::vector<Vec3>& directions) {
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const Vec3& n = directions[i];
    const double length = norm(n);
    if (!(length > 0)) continue;
    s.points[i] = s.points[i] + s.scale * std::abs(s.values[i]) / length * n;
  }
}

}  // namespace

double focal_scale(const kernel::TriangleMesh& mesh, const std::vector<double>& values,
                   double share) {
  std::vector<double> sizes;
  for (const double q : values)
    if (std::isfinite(q)) sizes.push_back(std::abs(q));
  if (sizes.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  const double typical = sizes[static_cast<std::size_t>(rank)];
  return typical > 0 ? share * diagonal(mesh) / typical : 0;
}

FocalSurface focal_of_triangles(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                                Quantity quantity, double share, int steps) {
  const auto nodes = lattice(steps);
  FocalSurface s;
  s.quantity = quantity;
  s.points.resize(nodes.size() * mesh.face_count());
  s.values.resize(s.points.size());
  std::vector<Vec3> directions(s.points.size());
  for_each_index(mesh.face_count(), [&](Index f) {
    const auto& t = mesh.faces()[f];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::size_t slot = f * nodes.size() + i;
      for (std::size_t k = 0; k < 3; ++k) {
        s.points[slot] = s.points[slot] + nodes[i][k] * mesh.points()[t[k]];
        directions[slot] = directions[slot] + nodes[i][k] * normals[t[k]];
      }
      const double q = value_of(curvature_at(mesh, normals, f, nodes[i]), quantity);
      s.values[slot] = std::isfinite(q) ? q : 0;
    }
  });
  s.scale = focal_scale(mesh, s.values, share);
  displace(s, directions);
  for (Index f = 0; f < mesh.face_count(); ++f)
    add_face(s, f, f * static_cast<Index>(nodes.size()), steps);
  return s;
}

FocalSurface focal_of_vertices(const kernel::TriangleMesh& mesh, const Result& result,
                               Quantity quantity, double share) {
  FocalSurface s;
  s.quantity = quantity;
  std::vector<Vec3> directions;
  std::vector<double> at_vertices;
  for (const PointCurvature& c : result.vertices) at_vertices.push_back(value_of(c, quantity));
  s.scale = focal_scale(mesh, at_vertices, share);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.faces()[f]) {
      s.points.push_back(mesh.points()[v]);
      s.values.push_back(at_vertices[v]);
      directions.push_back(result.normals[v]);
    }
    add_face(s, f, 3 * f, 1);
  }
  displace(s, directions);
  return s;
}

}  // namespace crest::curvature
