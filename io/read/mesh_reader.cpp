// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/mesh_reader.hpp"

#include <numeric>
#include <utility>

#include "io/clean/clean.hpp"
#include "io/clean/sound_mesh.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/coarse_grid.hpp"
#include "io/read/point_values.hpp"

namespace crest::io {
namespace {

FieldRequest fields(const MeshRequest& request) {
  return {request.field.has_value(), request.field.value_or(""), request.normals, request.step};
}

/// The mesh of a soup that needs no cleaning, in which vertices are points and faces cells.
bool take_sound_mesh(const Soup& soup, const MeshRequest& request, MeshFile& file,
                     Surface& surface) {
  std::optional<kernel::TriangleMesh> mesh = sound_mesh(soup, request.clean, file.cleanup);
  if (!mesh) return false;
  file.mesh = std::move(*mesh);
  const bool tags = !soup.point_tags.empty() || !soup.cell_tags.empty();
  if (!tags && !request.field && !request.normals) return true;  // nobody asks which point it is
  surface.point_of.resize(file.mesh.vertex_count());
  surface.cell_of.resize(file.mesh.face_count());
  std::iota(surface.point_of.begin(), surface.point_of.end(), kernel::Index{0});
  std::iota(surface.cell_of.begin(), surface.cell_of.end(), kernel::Index{0});
  return true;
}

}  // namespace

MeshFile mesh_of_soup(const Soup& soup, const MeshRequest& request) {
  MeshFile file;
  Surface surface;
  const bool sound = take_sound_mesh(soup, request, file, surface);
  if (!sound) surface = clean(soup, request.clean, Purpose::geometry, file.cleanup);
  file.warnings = soup.warnings;
  const std::vector<std::string> lines = words(file.cleanup);
  file.warnings.insert(file.warnings.end(), lines.begin(), lines.end());
  if (request.field) {
    const PointValues field(soup, *request.field, "choose a curvature with --method");
    file.values.reserve(surface.point_of.size());
    for (const kernel::Index point : surface.point_of) file.values.push_back(field.at(point));
    if (const auto note = field.note()) file.warnings.push_back(*note);
  }
  if (request.normals) file.normals = point_normals(soup, surface.point_of);
  file.numbers = file_numbers(soup, surface);
  if (!sound) file.mesh = kernel::TriangleMesh(std::move(surface.points), std::move(surface.faces));
  if (const auto rounded = coarse_grid(file.mesh)) file.warnings.push_back(*rounded);
  return file;
}

MeshFile read_mesh(const std::string& path, const MeshRequest& request) {
  MeshFile file;
  read_named(path, [&] { file = mesh_of_soup(read_soup(path, fields(request)), request); });
  return file;
}

MeshFile read_mesh_bytes(const std::string& name, std::string_view bytes,
                         const MeshRequest& request) {
  MeshFile file;
  read_named(name, [&] { file = mesh_of_soup(read_soup(name, bytes, fields(request)), request); });
  return file;
}

}  // namespace crest::io
