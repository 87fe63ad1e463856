// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An orthographic camera that fits the mesh.
#include <optional>

#include "algorithms/ridges/ridge_graph.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

inline double dot(const kernel::Vec3& a, const kernel::Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline kernel::Vec3 cross(const kernel::Vec3& a, const kernel::Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline kernel::Vec3 combine(double s, const kernel::Vec3& a, double t, const kernel::Vec3& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}
/// The unit vector, or `fallback` for one of length zero.
kernel::Vec3 normalised(const kernel::Vec3& a, const kernel::Vec3& fallback);

/// Axes and the map to pixels: x to the right, y down, depth away from the eye, all in pixels.
struct Camera {
  kernel::Vec3 right, up, forward;
  kernel::Vec3 centre;
  double scale;  ///< pixels per unit
  int width, height;

  kernel::Vec3 project(const kernel::Vec3& p) const {
    const kernel::Vec3 q = combine(1, p, -1, centre);
    return {0.5 * width + scale * dot(right, q), 0.5 * height - scale * dot(up, q),
            scale * dot(forward, q)};
  }
};

/// Along the thinnest axis of the mesh, tilted; of the candidates the one that faces the most
/// of the elliptic ridges, weighted by curvature (the most area without ridges).
kernel::Vec3 automatic_view(const kernel::TriangleMesh& mesh,
                            const std::vector<kernel::Vec3>& normals,
                            const ridges::RidgeGraph& graph);

/// Fits the mesh into `width` with a margin; the height follows, at most 1.4 widths.
Camera fit_camera(const kernel::TriangleMesh& mesh, const kernel::Vec3& view, int width);

/// Area-weighted unit normals of the vertices.
std::vector<kernel::Vec3> vertex_normals(const kernel::TriangleMesh& mesh);

}  // namespace crest::io
