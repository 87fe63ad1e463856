// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/strips/strip_writer.hpp"

#include "io/formats/files.hpp"
#include "io/page/scene.hpp"
#include "io/picture/patches.hpp"
#include "io/picture/picture_file.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;

/// The number of the strip each face is in.
std::vector<Index> strip_of_faces(const kernel::TriangleMesh& mesh, const strips::Strips& strips) {
  std::vector<Index> strip_of(mesh.face_count(), kernel::kNone);
  for (std::size_t s = 0; s < strips.count(); ++s)
    for (const kernel::Triangle& t : strips::triangles_of(strips, s))
      for (const Index f : mesh.fan(t[0])) {
        const kernel::Triangle& face = mesh.faces()[f];
        if (strips::least_first(face) == t) strip_of[f] = static_cast<Index>(s);
      }
  return strip_of;
}

}  // namespace

vtkSmartPointer<vtkPolyData> strip_poly_data(const std::vector<kernel::Vec3>& points,
                                             const strips::Strips& strips) {
  PolyData data;
  data.add_points(points);
  for (std::size_t s = 0; s < strips.count(); ++s) {
    const auto strip = strips.strip(s);
    const std::vector<PolyData::Id> ids(strip.begin(), strip.end());
    Columns& row = data.add_strip(ids);
    row.add("strip", static_cast<int>(s));
    row.add("faces", static_cast<int>(strips::triangles_of(strips, s).size()));
  }
  return data.data();
}

void write_strips(const std::string& path, const std::vector<kernel::Vec3>& points,
                  const strips::Strips& strips) {
  if (lower_extension(path) != ".vtp")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp");
  write_vtp(path, *strip_poly_data(points, strips));
}

void write_index_buffer(const std::string& path, const strips::Strips& strips) {
  std::string bytes;
  bytes.reserve(4 * (strips.vertices.size() + strips.count()));
  const auto add = [&](std::uint32_t v) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(v >> shift & 0xff);
  };
  for (std::size_t s = 0; s < strips.count(); ++s) {
    if (s > 0) add(0xffffffffu);
    for (const Index v : strips.strip(s)) add(v);
  }
  write_atomically(path, bytes);
}

void write_strip_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                         const strips::Strips& strips, const Viewpoint& viewpoint) {
  check_picture_path(path);
  check_viewpoint(viewpoint);
  const Camera camera = make_camera(mesh, viewpoint, 1200);
  Canvas canvas(camera.width, camera.height);
  draw_patches(canvas, camera, mesh, strip_of_faces(mesh, strips));
  write_drawing(path, camera, canvas, Drawing{}, false);
}

Scene strip_scene(const kernel::TriangleMesh& mesh, const strips::Strips& strips,
                  const Viewpoint& viewpoint) {
  Scene scene{"Triangle strips"};
  scene.camera = make_camera(mesh, viewpoint, 1200);
  SceneSurface surface = scene_surface("surface", mesh);
  SceneField field{"strip", {}, true, ColourMap::labels};
  for (const Index s : strip_of_faces(mesh, strips)) field.values.push_back(s);
  surface.fields.push_back(std::move(field));
  scene.surfaces.push_back(std::move(surface));
  SceneLayer layer{"Strips", {{"through the faces", {50, 54, 64}, 0.5}}, {{"faces", "faces"}}};
  for (std::size_t s = 0; s < strips.count(); ++s) {
    std::vector<kernel::Vec3> middles;
    for (const auto& t : strips::triangles_of(strips, s)) {
      const auto& p = mesh.points();
      middles.push_back(combine(1.0 / 3, combine(1, p[t[0]], 1, p[t[1]]), 1.0 / 3, p[t[2]]));
    }
    layer.add_item().add("faces", static_cast<int>(middles.size()));
    layer.add_line(middles, false, [](std::size_t) { return 0; });
  }
  scene.layers.push_back(std::move(layer));
  return scene;
}

}  // namespace crest::io
