// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/splines/isosurface_writer.hpp"

#include <vtkDoubleArray.h>

#include <cmath>

#include "io/formats/files.hpp"
#include "io/page/scene.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using splines::Isosurface;

std::string obj(const Isosurface& surface) {
  Text text;
  for (const auto& p : surface.points) text.add("v {} {} {}\n", p[0], p[1], p[2]);
  for (const auto& t : surface.triangles) text.add("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text.text();
}

std::string ply(const Isosurface& surface) {
  Text text;
  text.add(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      surface.points.size(), surface.triangles.size());
  for (const auto& p : surface.points) text.add("{} {} {}\n", p[0], p[1], p[2]);
  for (const auto& t : surface.triangles) text.add("3 {} {} {}\n", t[0], t[1], t[2]);
  return text.text();
}

}  // namespace

vtkSmartPointer<vtkPolyData> isosurface_poly_data(const Isosurface& surface,
                                                  const std::string& data_digest) {
  PolyData data;
  data.add_points(surface.points);
  for (const auto& t : surface.triangles) data.add_triangle(t[0], t[1], t[2]);
  vtkNew<vtkDoubleArray> gradients;
  gradients->SetName("gradient");
  gradients->SetNumberOfComponents(3);
  for (const auto& g : surface.gradients) gradients->InsertNextTuple(g.data());
  data.add_point_array(gradients);
  if (!data_digest.empty()) data.fields().add("data_digest", data_digest);
  return data.data();
}

void write_isosurface(const std::string& path, const Isosurface& surface,
                      const std::string& data_digest) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp") return write_vtp(path, *isosurface_poly_data(surface, data_digest));
  if (extension == ".obj") return write_atomically(path, obj(surface));
  if (extension == ".ply") return write_atomically(path, ply(surface));
  throw kernel::InputError(path + ": file: has an unknown extension; write .vtp, .obj or .ply");
}

Scene isosurface_scene(const splines::Isosurface& surface, const Viewpoint& viewpoint) {
  Scene scene{"Isosurface"};
  SceneSurface mesh{"isosurface", surface.points, surface.triangles};
  SceneField gradient{"gradient", {}};
  for (const kernel::Vec3& g : surface.gradients)
    gradient.values.push_back(std::hypot(g[0], g[1], g[2]));
  mesh.fields.push_back(std::move(gradient));
  mesh.coloured = false;
  if (!mesh.faces.empty())
    scene.camera = make_camera(SurfaceView(mesh.points, mesh.faces), viewpoint, 1200);
  scene.surfaces.push_back(std::move(mesh));
  return scene;
}

}  // namespace crest::io
