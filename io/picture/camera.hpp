// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An orthographic camera that fits the mesh.
#include <functional>
#include <optional>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

using kernel::cross;
using kernel::dot;

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

/// Points and faces of any mesh, as far as pictures need them. Refers to the mesh.
class SurfaceView {
 public:
  template <class Mesh>
  SurfaceView(const Mesh& mesh)  // NOLINT: meshes convert
      : points_(mesh.points()), faces_(mesh.faces()) {}
  SurfaceView(const std::vector<kernel::Vec3>& points, const std::vector<kernel::Triangle>& faces)
      : points_(points), faces_(faces) {}
  const std::vector<kernel::Vec3>& points() const { return points_; }
  const std::vector<kernel::Triangle>& faces() const { return faces_; }

 private:
  const std::vector<kernel::Vec3>& points_;
  const std::vector<kernel::Triangle>& faces_;
};

/// Along the thinnest axis of the mesh, tilted: of the candidates the first with the largest score.
kernel::Vec3 tilted_view(const SurfaceView& mesh,
                         const std::function<double(const kernel::Vec3& view)>& score_of);
/// The score is the area that faces the eye.
kernel::Vec3 tilted_view(const SurfaceView& mesh);

/// The same, but straight on a flat surface.
kernel::Vec3 automatic_view(const SurfaceView& mesh);

/// Fits the mesh into `width` with a margin; the height follows, at most 1.4 widths. `vertical`:
/// what points up in the picture; nothing: the y-axis, or z where the view is along y.
Camera fit_camera(const SurfaceView& mesh, const kernel::Vec3& view, int width,
                  const std::optional<kernel::Vec3>& vertical = {});

/// Area-weighted unit normals of the vertices.
std::vector<kernel::Vec3> vertex_normals(const SurfaceView& mesh);

}  // namespace crest::io
