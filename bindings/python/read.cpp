// SPDX-License-Identifier: GPL-3.0-or-later
// Files as arrays.
#include "bindings/python/systems.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/read/planar_field_reader.hpp"
#include "io/read/point_reader.hpp"
#include "io/read/tet_reader.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::python {
namespace {

std::optional<std::int64_t> step_of(const Arguments& a) {
  return a.has("step") ? std::optional<std::int64_t>(a.integer("step")) : std::nullopt;
}

std::string field_of(const Arguments& a, const char* name) {
  return a.has(name) ? a.text(name) : std::string();
}

}  // namespace

Output run_read_mesh(const Arguments& a, const Progress& progress) {
  io::MeshRequest request;
  request.clean = {a.maybe_number("weld"), a.flag("split"), a.flag("outward")};
  if (a.flag("with_field")) request.field = field_of(a, "field");
  request.normals = a.flag("with_normals");
  request.step = step_of(a);
  io::MeshFile file = progress.step("reading " + a.text("path"),
                                    [&] { return io::read_mesh(a.text("path"), request); });
  Output out;
  out.values["V"] = array_of(file.mesh.points());
  out.values["F"] = array_of(file.mesh.faces());
  if (request.field) out.values["values"] = array_of(std::move(file.values));
  if (request.normals) out.values["normals"] = array_of(file.normals);
  out.warnings = std::move(file.warnings);
  return out;
}

Output run_read_tensors(const Arguments& a, const Progress& progress) {
  const io::TensorRequest request{field_of(a, "tensor"), field_of(a, "order"), step_of(a)};
  const io::TensorFile file = progress.step(
      "reading " + a.text("path"), [&] { return io::read_tensors(a.text("path"), request); });
  Output out;
  out.values["V"] = array_of(file.mesh.points());
  out.values["T"] = array_of(file.mesh.tets());
  out.values["tensors"] = array_of(file.tensors);
  out.warnings = file.warnings;
  return out;
}

Output run_read_vectors(const Arguments& a, const Progress& progress) {
  io::VectorRequest request;
  request.field = field_of(a, "vectors");
  request.cell_to_point = a.flag("cell_to_point");
  request.all = a.flag("all");
  if (a.has("slice")) request.slice = a.integer("slice");
  const std::string& diagonal = a.text("diagonal");
  request.diagonal = diagonal == "down"    ? io::Diagonal::down
                     : diagonal == "short" ? io::Diagonal::shorter
                                           : io::Diagonal::up;
  const io::PlanarFieldFile file = progress.step(
      "reading " + a.text("path"), [&] { return io::read_planar_field(a.text("path"), request); });
  Output out;
  out.values["V"] = array_of(file.points);
  out.values["F"] = array_of(file.triangles);
  out.values["vectors"] = array_of(file.vectors);
  out.warnings = file.warnings;
  return out;
}

Output run_read_volume(const Arguments& a, const Progress& progress) {
  io::VolumeFile file = progress.step("reading " + a.text("path"), [&] {
    return io::read_volume(a.text("path"), {field_of(a, "field"), field_of(a, "raw")});
  });
  Output out;
  const kernel::SampledGrid& grid = file.grid;
  // NumPy's last index is the fastest, the grid's first.
  std::vector<std::size_t> shape = {grid.size[2], grid.size[1], grid.size[0]};
  if (grid.dimension() == 2) shape.erase(shape.begin());
  std::vector<std::array<double, 3>> directions(grid.directions.begin(), grid.directions.end());
  out.values["spacing"] = std::vector<double>(grid.spacing.begin(), grid.spacing.end());
  out.values["origin"] = std::vector<double>(grid.origin.begin(), grid.origin.end());
  out.values["directions"] = array_of(directions);
  out.values["samples"] = Array{std::move(shape), std::move(file.grid.samples)};
  out.warnings = file.warnings;
  return out;
}

Output run_read_points(const Arguments& a, const Progress& progress) {
  const io::PointFile file =
      progress.step("reading " + a.text("path"), [&] { return io::read_points(a.text("path")); });
  Output out;
  out.values["points"] = array_of(file.points);
  out.values["normals"] = array_of(file.normals);
  out.warnings = file.warnings;
  return out;
}

}  // namespace crest::python
