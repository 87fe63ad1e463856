// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "algorithms/extremal/components.hpp"

namespace crest::extremal {
namespace {

using Field = std::function<Local(const Vec3&)>;

/// lambda1 / (lambda1 + lambda2); an image's third direction does not count.
double plateness_of(const Tensor& t, const Vec3& n, bool plane) {
  const double first = kernel::dot(n, product(t, n));
  double second;
  if (plane) {
    second = t[0] + t[1] - first;
  } else {
    const auto [u, v] = kernel::frame_across(n);
    const Vec3 tu = product(t, u), tv = product(t, v);
    const double a = kernel::dot(u, tu), b = kernel::dot(u, tv), c = kernel::dot(v, tv);
    second = 0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  }
  const double sum = first + second;
  return sum > 0 ? std::clamp(first / sum, 0.0, 1.0) : 1;
}

/// n on the side of the first polygon that has the point.
void turn_normals(Result& result) {
  std::vector<bool> seen(result.points.size(), false);
  for (std::size_t p = 0; p < result.polygons(); ++p) {
    const Index begin = result.first[p], end = result.first[p + 1];
    Vec3 across{};
    for (Index i = begin + 2; i < end; ++i)
      across =
          across +
          kernel::cross(result.points[result.corners[i - 1]] - result.points[result.corners[begin]],
                        result.points[result.corners[i]] - result.points[result.corners[begin]]);
    for (Index i = begin; i < end; ++i) {
      const Index v = result.corners[i];
      if (!seen[v] && kernel::dot(across, result.normals[v]) < 0)
        result.normals[v] = -1.0 * result.normals[v];
      seen[v] = true;
    }
  }
}

/// Points that polygons use, in their order, with n.
void write_points(const Grid& grid, const MeasuredMesh& mesh, const Field& field, Result& result) {
  const TrimmedMesh& t = mesh.trimmed;
  std::vector<Index> number(t.points.size(), kernel::kNone), kept;
  for (const Index v : t.corners) number[v] = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kernel::kNone) continue;
    number[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  result.points.resize(kept.size());
  result.normals.resize(kept.size());
  std::vector<double> residuals(kept.size());
  const Vec3& d = grid.spacing;
  const double least = std::min({d[0], d[1], result.dimension == 2 ? d[0] : d[2]});
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kept.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Local l = field(t.points[kept[i]]);
      result.points[i] = grid.position(t.points[kept[i]]);
      result.normals[i] = dominant_direction(l.tensor);
      const Vec3& n = result.normals[i];
      const double bend = std::fabs(kernel::dot(n, product(l.hessian, n))) * least;
      residuals[i] = bend > 0 ? std::fabs(kernel::dot(n, l.gradient)) / bend : 0;
    }
  });
  for (const double x : residuals) result.max_residual = std::max(result.max_residual, x);
  result.first = t.first;
  for (const Index v : t.corners) result.corners.push_back(number[v]);
  for (const Feature& f : t.features)
    result.features.push_back({number[f.a], number[f.b], f.reason});
  if (result.dimension == 3) turn_normals(result);
}

void write_polygons(const MeasuredMesh& mesh, const Field& field, Result& result) {
  const std::size_t count = mesh.trimmed.source.size();
  result.component = mesh.measured.component_of;
  result.critical_type.resize(count);
  result.strength.resize(count);
  result.s.resize(count);
  result.plateness.resize(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const SheetPolygon& p = mesh.sheets.polygons[mesh.trimmed.source[i]];
      const Local l = field(p.zero);
      const Vec3 n = dominant_direction(l.tensor);
      result.critical_type[i] = p.extremal ? 1 : 0;
      result.strength[i] = kernel::dot(n, product(l.hessian, n));
      result.s[i] = l.s;
      result.plateness[i] = plateness_of(l.tensor, n, result.dimension == 2);
    }
  });
}

}  // namespace

void write_mesh(const Grid& grid, const MeasuredMesh& mesh, const Field& field, Result& result) {
  write_points(grid, mesh, field, result);
  write_polygons(mesh, field, result);
  result.components = mesh.measured.components;
}

}  // namespace crest::extremal
