// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/ridge_picture.hpp"

#include "io/picture/picture_file.hpp"
#include "io/ridges/ridge_drawing.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {

void check_picture(const std::string& path, const PictureOptions& options) {
  check_picture_path(path);
  if (options.width < 16 || options.width > 16384)
    throw kernel::InputError(path + ": picture: the width is out of range; take 16 to 16384");
  check_viewpoint({options.view, options.up});
}

void write_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                   const ridges::RidgeGraph& graph, const PictureOptions& options) {
  check_picture(path, options);
  const std::vector<kernel::Vec3> normals = vertex_normals(mesh);
  const Camera camera = make_camera(mesh, {options.view, options.up}, options.width,
                                    view_score(mesh, normals, graph));
  Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, normals);
  write_drawing(path, camera, canvas, make_drawing(camera, canvas, mesh, normals, graph, options),
                options.show_legend);
}

}  // namespace crest::io
