// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An orthographic camera that fits the mesh.
#include <functional>
#include <optional>

#include "io/picture/viewpoint.hpp"
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

using ViewScore = std::function<double(const kernel::Vec3& view)>;

/// The camera that a caller asks for. What is left open is chosen:
/// - view and up: of views along the thinnest principal axis, tilted, the first with the largest
///   score, y up (z where the view is along y), if that shows the shape as it stands
///   (standing_direction) or it stands nowhere. Else, lest it be tipped over, as with that up
///   alone;
/// - view, to an up: of horizontal views along the thinnest horizontal axis, turned and from a
///   little above, the first with the largest score;
/// - up, to a view: the direction in which the shape stands, else y, else (along the view) z.
/// `score`: nothing: the area that faces the eye. A flat surface is seen straight on, unless
/// `tilt_flat`.
/// The shape fits into `width` with a margin; the height follows, at most 1.4 widths.
Camera make_camera(const SurfaceView& mesh, const Viewpoint& wanted, int width,
                   const ViewScore& score = {}, bool tilt_flat = true);

/// Throws: kernel::InputError of one line for directions that are none, or the same.
void check_viewpoint(const Viewpoint& wanted);

/// Area-weighted unit normals of the vertices.
std::vector<kernel::Vec3> vertex_normals(const SurfaceView& mesh);

}  // namespace crest::io
