// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/extremal/components.hpp"

namespace crest::extremal {
namespace {

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
void write_points(const Grid& grid, TrimmedMesh& t, const ValuesAt& values, Result& result) {
  std::vector<Index> number(t.points.size(), kernel::kNone), kept;
  for (const Index v : t.corners) number[v] = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kernel::kNone) continue;
    number[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  std::vector<Vec3> places;
  places.reserve(kept.size());
  for (const Index v : kept) places.push_back(t.points[v]);
  t.points = {};
  kept = {};
  const Vec3& d = grid.spacing;
  const double least = std::min({d[0], d[1], result.dimension == 2 ? d[0] : d[2]});
  result.normals.reserve(places.size());
  for (const AtPlace& at : values(places)) {
    result.normals.push_back(at.normal);
    const double bend = std::fabs(at.bend) * least;
    result.max_residual = std::max(result.max_residual, bend > 0 ? std::fabs(at.slope) / bend : 0);
  }
  for (Vec3& x : places) x = grid.position(x);
  result.points = std::move(places);
  result.first = std::move(t.first);
  result.corners = std::move(t.corners);
  for (Index& v : result.corners) v = number[v];
  result.first.shrink_to_fit();  // both grew by doubling
  result.corners.shrink_to_fit();
  for (const Feature& f : t.features)
    result.features.push_back({number[f.a], number[f.b], f.reason});
  if (result.dimension == 3) turn_normals(result);
}

void write_polygons(MeasuredMesh& mesh, const ValuesAt& values, Result& result) {
  result.component = std::move(mesh.measured.component_of);
  std::vector<Vec3> places;
  places.reserve(mesh.trimmed.source.size());
  for (const Index p : mesh.trimmed.source) places.push_back(mesh.sheets.polygons[p].zero);
  for (std::vector<double>* list : {&result.strength, &result.s, &result.plateness})
    list->reserve(places.size());
  result.critical_type.reserve(places.size());
  for (const AtPlace& at : values(places)) {
    const Index source = mesh.trimmed.source[result.strength.size()];
    result.critical_type.push_back(mesh.sheets.polygons[source].extremal ? 1 : 0);
    result.strength.push_back(at.bend);
    result.s.push_back(at.s);
    result.plateness.push_back(at.plateness);
  }
}

}  // namespace

void write_mesh(const Grid& grid, MeasuredMesh& mesh, const ValuesAt& values, Result& result) {
  mesh.sheets.vertices = {};
  mesh.sheets.edges = {};
  write_points(grid, mesh.trimmed, values, result);
  write_polygons(mesh, values, result);
  result.components = std::move(mesh.measured.components);
}

}  // namespace crest::extremal
