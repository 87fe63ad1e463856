// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/ridge_picture.hpp"

#include <cmath>

#include "io/picture/picture_file.hpp"
#include "io/ridges/ridge_drawing.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {

void check_picture(const std::string& path, const PictureOptions& options) {
  check_picture_path(path);
  if (options.width < 16 || options.width > 16384)
    throw kernel::InputError(path + ": picture: the width is out of range; take 16 to 16384");
  if (!options.view) return;
  const kernel::Vec3& v = *options.view;
  const double squared = dot(v, v);
  if (!(squared > 0) || !std::isfinite(squared))
    throw kernel::InputError(path + ": picture: the view is no direction; give three numbers");
}

void write_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                   const ridges::RidgeGraph& graph, const PictureOptions& options) {
  check_picture(path, options);
  const std::vector<kernel::Vec3> normals = vertex_normals(mesh);
  const kernel::Vec3 view = options.view ? *options.view : ridge_view(mesh, normals, graph);
  const Camera camera = fit_camera(mesh, view, options.width);
  Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, normals);
  write_drawing(path, camera, canvas, make_drawing(camera, canvas, mesh, normals, graph, options),
                options.show_legend);
}

}  // namespace crest::io
