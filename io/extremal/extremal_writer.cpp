// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/extremal/extremal_writer.hpp"

#include <vtkDoubleArray.h>

#include <span>

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "io/write/vtk_pieces.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using extremal::Result;
using kernel::Index;

std::span<const Index> corners_of(const Result& r, std::size_t polygon) {
  return {r.corners.data() + r.first[polygon], r.corners.data() + r.first[polygon + 1]};
}

std::string obj(const Result& r) {
  Text text;
  for (const auto& p : r.points) text.add("v {} {} {}\n", p[0], p[1], p[2]);
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    text.add("{}", r.dimension == 2 ? "l" : "f");
    for (const Index v : corners_of(r, p)) text.add(" {}", v + 1);
    text.add("\n");
  }
  return text.text();
}

std::string ply(const Result& r) {
  Text text;
  text.add(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement {} {}\n{}end_header\n",
      r.points.size(), r.dimension == 2 ? "edge" : "face", r.polygons(),
      r.dimension == 2 ? "property int vertex1\nproperty int vertex2\n"
                       : "property list uchar int vertex_indices\n");
  for (const auto& p : r.points) text.add("{} {} {}\n", p[0], p[1], p[2]);
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    const auto corners = corners_of(r, p);
    if (r.dimension == 3) text.add("{} ", corners.size());
    text.add("{}\n", fmt::join(corners, " "));
  }
  return text.text();
}

}  // namespace

vtkSmartPointer<vtkPolyData> extremal_poly_data(const Result& r, const std::string& data_digest) {
  PolyData data;
  data.add_points(r.points);
  std::vector<PolyData::Id> ids;
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    const auto corners = corners_of(r, p);
    ids.assign(corners.begin(), corners.end());
    Columns& row = r.dimension == 2 ? data.add_line(ids) : data.add_polygon(ids);
    row.add("critical_type", int{r.critical_type[p]});
    row.add("component", static_cast<int>(r.component[p]));
    row.add("strength", r.strength[p]);
    row.add("s", r.s[p]);
    row.add("plateness", r.plateness[p]);
    row.add("feature", 0);
  }
  for (const extremal::Feature& f : r.features) {
    Columns& row =
        f.a == f.b ? data.add_vertex(f.a) : data.add_line(std::array<PolyData::Id, 2>{f.a, f.b});
    row.add("critical_type", -1);
    row.add("component", -1);
    row.add("strength", 0.0);
    row.add("s", 0.0);
    row.add("plateness", 0.0);
    row.add("feature", static_cast<int>(f.reason));
  }
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("normal");
  normals->SetNumberOfComponents(3);
  normals->Allocate(static_cast<vtkIdType>(3 * r.normals.size()));
  for (const auto& n : r.normals) normals->InsertNextTuple(n.data());
  data.add_point_array(normals);
  if (!data_digest.empty()) data.fields().add("data_digest", data_digest);
  return data.data();
}

void write_extremal(const std::string& path, const Result& result, const std::string& data_digest) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp") return write_vtp(path, *extremal_poly_data(result, data_digest));
  if (extension == ".pvtp") return write_pvtp(path, *extremal_poly_data(result, data_digest));
  if (extension == ".obj") return write_atomically(path, obj(result));
  if (extension == ".ply") return write_atomically(path, ply(result));
  throw kernel::InputError(path +
                           ": file: has an unknown extension; write .vtp, .pvtp, .obj or .ply");
}

}  // namespace crest::io
