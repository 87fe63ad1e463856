// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Principal directions as strokes over a close-up: the larger ones red, the smaller ones blue.
#include "experiments/close_up.hpp"

namespace crest::experiments {

/// A close-up of a ball with both directions at every vertex, 0.9 of its shortest edge long.
inline void write_directions(const std::string& path, const kernel::TriangleMesh& mesh,
                             const curvature::Result& result, const Vec3& centre, double radius) {
  using kernel::norm;
  using kernel::operator+, kernel::operator-, kernel::operator*;
  const std::vector<Vec3> normals = curvature::area_weighted_normals(mesh);
  CloseUp view;
  view.centre = centre;
  view.radius = radius;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.points()[v];
    double edge = 1e300;
    for (const Index w : mesh.ring(v)) edge = std::min(edge, norm(mesh.points()[w] - p));
    const auto add = [&](const Vec3& d, const char* colour) {
      view.lines.push_back({p - 0.45 * edge * d, p + 0.45 * edge * d, normals[v], colour, 1.2});
    };
    add(result.vertices[v].d1, "#c81e1e");
    add(result.vertices[v].d2, "#1e46c8");
  }
  write_close_up(path, mesh, view);
}

}  // namespace crest::experiments
