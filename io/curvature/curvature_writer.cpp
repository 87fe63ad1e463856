// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curvature/curvature_writer.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <limits>
#include <utility>

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/late_array.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "io/write/vtk_pieces.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using curvature::PointCurvature;
using kernel::Index;
using kernel::Vec3;

struct Scalar {
  const char* name;
  double PointCurvature::*member;
};
constexpr Scalar kScalars[] = {{"k1", &PointCurvature::k1},
                               {"k2", &PointCurvature::k2},
                               {"K", &PointCurvature::K},
                               {"H", &PointCurvature::H},
                               {"asymmetry", &PointCurvature::asymmetry}};
struct Direction {
  const char* name;
  Vec3 PointCurvature::*member;
};
constexpr Direction kDirections[] = {{"d1", &PointCurvature::d1}, {"d2", &PointCurvature::d2}};

/// When the arrays of a data set get their numbers. late: when they are written, and what the mesh
/// and the result hold as the file has it stays there, which both must outlive.
enum class Made { now, late };

/// fill: writes rows x components numbers.
vtkSmartPointer<vtkDoubleArray> array(Made made, const std::string& name, int components,
                                      std::size_t rows, std::function<void(double*)> fill) {
  vtkSmartPointer<vtkDoubleArray> a;
  if (made == Made::late) {
    vtkNew<LateArray> late;
    late->rows = static_cast<vtkIdType>(rows);
    late->fill = std::move(fill);
    a = late;
  } else {
    a = vtkSmartPointer<vtkDoubleArray>::New();
  }
  a->SetName(name.c_str());
  a->SetNumberOfComponents(components);
  if (made == Made::late) return a;
  a->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  fill(a->GetPointer(0));
  return a;
}

vtkSmartPointer<vtkDoubleArray> array(Made made, const std::vector<Vec3>& vectors) {
  auto a = vtkSmartPointer<vtkDoubleArray>::New();
  a->SetNumberOfComponents(3);
  if (made == Made::late && !vectors.empty()) {
    // VTK only reads them, and has no pointer to what it must not write.
    auto* const numbers = const_cast<double*>(vectors.data()->data());
    a->SetArray(numbers, static_cast<vtkIdType>(3 * vectors.size()), 1);
    return a;
  }
  a->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
  double* out = a->GetPointer(0);
  for (const Vec3& v : vectors) out = std::copy(v.begin(), v.end(), out);
  return a;
}

void add_point_data(Made made, vtkPointData& data, const curvature::Result& result) {
  const std::vector<PointCurvature>& vertices = result.vertices;
  for (const Scalar& s : kScalars)
    data.AddArray(array(made, s.name, 1, vertices.size(), [&vertices, s](double* out) {
      for (const PointCurvature& c : vertices) *out++ = c.*s.member;
    }));
  for (const Direction& d : kDirections)
    data.AddArray(array(made, d.name, 3, vertices.size(), [&vertices, d](double* out) {
      for (const PointCurvature& c : vertices)
        for (const double x : c.*d.member) *out++ = x;
    }));
  const auto normals = array(made, result.normals);
  normals->SetName("Normals");
  data.SetNormals(normals);
}

void add_cell_data(Made made, vtkCellData& data,
                   const std::vector<curvature::CornerCurvatures>& corners) {
  if (corners.empty()) return;
  const std::string corner = "corner_";
  for (const Scalar& s : kScalars)
    data.AddArray(array(made, corner + s.name, 3, corners.size(), [&corners, s](double* out) {
      for (const auto& face : corners)
        for (const PointCurvature& c : face) *out++ = c.*s.member;
    }));
  for (const Direction& d : kDirections)
    data.AddArray(array(made, corner + d.name, 9, corners.size(), [&corners, d](double* out) {
      for (const auto& face : corners)
        for (const PointCurvature& c : face)
          for (const double x : c.*d.member) *out++ = x;
    }));
}

vtkSmartPointer<vtkPoints> vtk_points(Made made, const std::vector<Vec3>& points) {
  auto out = vtkSmartPointer<vtkPoints>::New();
  out->SetData(array(made, points));
  return out;
}

vtkSmartPointer<vtkCellArray> vtk_triangles(Made made, const std::vector<kernel::Triangle>& faces) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max() / 3;
  if (made == Made::late && !faces.empty() && faces.size() < most) {  // so have the corners 31 bits
    vtkNew<vtkTypeInt32Array> begin, corners;
    begin->SetNumberOfValues(static_cast<vtkIdType>(faces.size()) + 1);
    for (std::size_t f = 0; f <= faces.size(); ++f)
      begin->SetValue(static_cast<vtkIdType>(f), static_cast<std::int32_t>(3 * f));
    static_assert(sizeof(kernel::Triangle) == 3 * sizeof(std::int32_t));
    auto* const numbers = reinterpret_cast<std::int32_t*>(const_cast<Index*>(faces.data()->data()));
    corners->SetArray(numbers, static_cast<vtkIdType>(3 * faces.size()), 1);
    cells->SetData(begin, corners);
    return cells;
  }
  for (const auto& f : faces)
    cells->InsertNextCell({vtkIdType{f[0]}, vtkIdType{f[1]}, vtkIdType{f[2]}});
  return cells;
}

vtkSmartPointer<vtkPolyData> poly_data(Made made, const kernel::TriangleMesh& mesh,
                                       const curvature::Result& result,
                                       const std::vector<curvature::CornerCurvatures>& corners) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(made, mesh.points()));
  data->SetPolys(vtk_triangles(made, mesh.faces()));
  add_point_data(made, *data->GetPointData(), result);
  add_cell_data(made, *data->GetCellData(), corners);
  return data;
}

/// Numbers in a file's bytes, handed on in pieces.
class BinaryNumbers {
 public:
  explicit BinaryNumbers(const Sink& sink) : sink_(sink) {}
  template <class T>
  void add(T number) {
    if (used_ + sizeof number > buffer_.size()) flush();
    std::memcpy(buffer_.data() + used_, &number, sizeof number);
    used_ += sizeof number;
  }
  void add(const Vec3& v) {
    for (const double x : v) add(x);
  }
  void flush() { sink_({buffer_.data(), std::exchange(used_, 0)}); }

 private:
  const Sink& sink_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t used_ = 0;
};

std::string ply_header(const kernel::TriangleMesh& mesh) {
  Text text;
  text.add("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.vertex_count());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text.add("property double {}\n", name);
  for (const Scalar& s : kScalars) text.add("property double {}\n", s.name);
  for (const Direction& d : kDirections)
    for (const char axis : {'x', 'y', 'z'}) text.add("property double {}{}\n", d.name, axis);
  text.add("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
           mesh.face_count());
  return text.text();
}

void write_ply(const std::string& path, const kernel::TriangleMesh& mesh,
               const curvature::Result& result) {
  write_atomically(path, [&](const Sink& sink) {
    sink(ply_header(mesh));
    BinaryNumbers numbers(sink);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const PointCurvature& c = result.vertices[v];
      numbers.add(mesh.points()[v]);
      numbers.add(result.normals[v]);
      for (const Scalar& s : kScalars) numbers.add(c.*s.member);
      for (const Direction& d : kDirections) numbers.add(c.*d.member);
    }
    for (const kernel::Triangle& f : mesh.faces()) {
      numbers.add(std::uint8_t{3});
      for (const Index v : f) numbers.add(static_cast<std::int32_t>(v));
    }
    numbers.flush();
  });
}

std::array<unsigned char, 3> focal_colour(double q) {
  if (q == 0) return {128, 128, 128};
  return q < 0 ? std::array<unsigned char, 3>{200, 0, 0} : std::array<unsigned char, 3>{0, 160, 0};
}

void add_row(Columns& row, const curvature::FocalSurface& s, Index face, bool curve) {
  row.add("quantity", static_cast<int>(s.quantity));
  row.add("face", static_cast<int>(face));
  row.add("curve", curve ? 1 : 0);
}

void add_focal(const curvature::FocalSurface& s, PolyData& data, vtkUnsignedCharArray& colours) {
  const PolyData::Id base = data.point_count();
  data.add_points(s.points);
  for (const double q : s.values) {
    data.point_rows().add("value", q);
    colours.InsertNextTypedTuple(focal_colour(q).data());
  }
  const std::size_t per_face = s.curves.empty() ? 1 : s.triangles.size() / s.curves.size();
  for (std::size_t i = 0; i < s.curves.size(); ++i) {
    std::vector<PolyData::Id> line;
    for (const Index p : s.curves[i]) line.push_back(base + p);
    add_row(data.add_line(line), s, s.faces[i * per_face], true);
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto& [a, b, c] = s.triangles[i];
    add_row(data.add_triangle(base + a, base + b, base + c), s, s.faces[i], false);
  }
  data.fields().add("scale", s.scale);
}

}  // namespace

vtkSmartPointer<vtkPolyData> curvature_poly_data(
    const kernel::TriangleMesh& mesh, const curvature::Result& result,
    const std::vector<curvature::CornerCurvatures>& corners) {
  return poly_data(Made::now, mesh, result, corners);
}

void write_curvature(const std::string& path, const kernel::TriangleMesh& mesh,
                     const curvature::Result& result,
                     const std::vector<curvature::CornerCurvatures>& corners) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp") {
    write_vtp(path, *poly_data(Made::late, mesh, result, corners));
  } else if (extension == ".pvtp") {
    write_pvtp(path, *curvature_poly_data(mesh, result, corners));
  } else if (extension == ".vtu" || extension == ".pvtu") {
    const Made made = extension == ".vtu" ? Made::late : Made::now;
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(vtk_points(made, mesh.points()));
    grid->SetCells(VTK_TRIANGLE, vtk_triangles(made, mesh.faces()));
    add_point_data(made, *grid->GetPointData(), result);
    add_cell_data(made, *grid->GetCellData(), corners);
    extension == ".vtu" ? write_vtu(path, *grid) : write_pvtu(path, *grid);
  } else if (extension == ".ply") {
    write_ply(path, mesh, result);
  } else {
    throw kernel::InputError(path +
                             ": file: has an unknown extension; write .vtp .pvtp .vtu .pvtu .ply");
  }
}

void write_focal(const std::string& path, const std::vector<curvature::FocalSurface>& surfaces) {
  if (lower_extension(path) != ".vtp")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp");
  PolyData data;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colour");
  colours->SetNumberOfComponents(3);
  data.add_point_array(colours);
  for (const curvature::FocalSurface& surface : surfaces) add_focal(surface, data, *colours);
  write_vtp(path, *data.data());
}

}  // namespace crest::io
