// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curvature/curvature_writer.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <iterator>

#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
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

vtkSmartPointer<vtkDoubleArray> array(const std::string& name, int components, std::size_t tuples) {
  auto a = vtkSmartPointer<vtkDoubleArray>::New();
  a->SetName(name.c_str());
  a->SetNumberOfComponents(components);
  a->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return a;
}

void add_point_data(vtkPointData& data, const curvature::Result& result) {
  for (const Scalar& s : kScalars) {
    auto a = array(s.name, 1, result.vertices.size());
    double* out = a->GetPointer(0);
    for (const PointCurvature& c : result.vertices) *out++ = c.*s.member;
    data.AddArray(a);
  }
  for (const Direction& d : kDirections) {
    auto a = array(d.name, 3, result.vertices.size());
    double* out = a->GetPointer(0);
    for (const PointCurvature& c : result.vertices)
      for (const double x : c.*d.member) *out++ = x;
    data.AddArray(a);
  }
  auto normals = array("Normals", 3, result.normals.size());
  double* out = normals->GetPointer(0);
  for (const Vec3& n : result.normals)
    for (const double x : n) *out++ = x;
  data.SetNormals(normals);
}

void add_cell_data(vtkCellData& data, const std::vector<curvature::CornerCurvatures>& corners) {
  if (corners.empty()) return;
  for (const Scalar& s : kScalars) {
    auto a = array(std::string("corner_") + s.name, 3, corners.size());
    double* out = a->GetPointer(0);
    for (const auto& corner : corners)
      for (const PointCurvature& c : corner) *out++ = c.*s.member;
    data.AddArray(a);
  }
  for (const Direction& d : kDirections) {
    auto a = array(std::string("corner_") + d.name, 9, corners.size());
    double* out = a->GetPointer(0);
    for (const auto& corner : corners)
      for (const PointCurvature& c : corner)
        for (const double x : c.*d.member) *out++ = x;
    data.AddArray(a);
  }
}

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<Vec3>& points) {
  auto out = vtkSmartPointer<vtkPoints>::New();
  out->SetDataTypeToDouble();
  out->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    out->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  return out;
}

vtkSmartPointer<vtkCellArray> vtk_triangles(const std::vector<kernel::Triangle>& faces) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& f : faces)
    cells->InsertNextCell({vtkIdType{f[0]}, vtkIdType{f[1]}, vtkIdType{f[2]}});
  return cells;
}

std::string ply_of(const kernel::TriangleMesh& mesh, const curvature::Result& result) {
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "ply\nformat ascii 1.0\nelement vertex {}\n", mesh.vertex_count());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    fmt::format_to(out, "property double {}\n", name);
  for (const Scalar& s : kScalars) fmt::format_to(out, "property double {}\n", s.name);
  for (const Direction& d : kDirections)
    for (const char axis : {'x', 'y', 'z'})
      fmt::format_to(out, "property double {}{}\n", d.name, axis);
  fmt::format_to(out, "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                 mesh.face_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const PointCurvature& c = result.vertices[v];
    fmt::format_to(out, "{} {}", fmt::join(mesh.points()[v], " "),
                   fmt::join(result.normals[v], " "));
    for (const Scalar& s : kScalars) fmt::format_to(out, " {}", c.*s.member);
    for (const Direction& d : kDirections) fmt::format_to(out, " {}", fmt::join(c.*d.member, " "));
    fmt::format_to(out, "\n");
  }
  for (const auto& f : mesh.faces()) fmt::format_to(out, "3 {} {} {}\n", f[0], f[1], f[2]);
  return fmt::to_string(text);
}

struct FocalArrays {
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values, scales;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkCellArray> lines, triangles;
  // VTK numbers lines before triangles.
  vtkNew<vtkIntArray> quantity[2], face[2], curve[2];
};

void add_focal(const curvature::FocalSurface& s, FocalArrays& out) {
  const vtkIdType base = out.points->GetNumberOfPoints();
  const int code = static_cast<int>(s.quantity);
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    out.points->InsertNextPoint(s.points[i].data());
    out.values->InsertNextValue(s.values[i]);
    const double q = s.values[i];
    const unsigned char rgb[3] = {static_cast<unsigned char>(q < 0   ? 200
                                                             : q > 0 ? 0
                                                                     : 128),
                                  static_cast<unsigned char>(q < 0   ? 0
                                                             : q > 0 ? 160
                                                                     : 128),
                                  static_cast<unsigned char>(q == 0 ? 128 : 0)};
    out.colours->InsertNextTypedTuple(rgb);
  }
  const std::size_t per_face = s.curves.empty() ? 1 : s.triangles.size() / s.curves.size();
  for (std::size_t i = 0; i < s.curves.size(); ++i) {
    out.lines->InsertNextCell(static_cast<int>(s.curves[i].size()));
    for (const Index p : s.curves[i]) out.lines->InsertCellPoint(base + p);
    out.quantity[0]->InsertNextValue(code);
    out.face[0]->InsertNextValue(static_cast<int>(s.faces[i * per_face]));
    out.curve[0]->InsertNextValue(1);
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto& t = s.triangles[i];
    out.triangles->InsertNextCell({base + t[0], base + t[1], base + t[2]});
    out.quantity[1]->InsertNextValue(code);
    out.face[1]->InsertNextValue(static_cast<int>(s.faces[i]));
    out.curve[1]->InsertNextValue(0);
  }
  out.scales->InsertNextValue(s.scale);
}

}  // namespace

void write_curvature(const std::string& path, const kernel::TriangleMesh& mesh,
                     const curvature::Result& result,
                     const std::vector<curvature::CornerCurvatures>& corners) {
  const std::string extension = lower_extension(path);
  std::string bytes;
  if (extension == ".vtp") {
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtk_points(mesh.points()));
    data->SetPolys(vtk_triangles(mesh.faces()));
    add_point_data(*data->GetPointData(), result);
    add_cell_data(*data->GetCellData(), corners);
    bytes = vtp_bytes(*data);
  } else if (extension == ".vtu") {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(vtk_points(mesh.points()));
    grid->SetCells(VTK_TRIANGLE, vtk_triangles(mesh.faces()));
    add_point_data(*grid->GetPointData(), result);
    add_cell_data(*grid->GetCellData(), corners);
    bytes = vtu_bytes(*grid);
  } else if (extension == ".ply") {
    bytes = ply_of(mesh, result);
  } else {
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp .vtu .ply");
  }
  write_atomically(path, bytes);
}

void write_focal(const std::string& path, const std::vector<curvature::FocalSurface>& surfaces) {
  if (lower_extension(path) != ".vtp")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp");
  FocalArrays arrays;
  arrays.points->SetDataTypeToDouble();
  arrays.values->SetName("value");
  arrays.scales->SetName("scale");
  arrays.colours->SetName("colour");
  arrays.colours->SetNumberOfComponents(3);
  for (const curvature::FocalSurface& s : surfaces) add_focal(s, arrays);
  vtkNew<vtkPolyData> data;
  data->SetPoints(arrays.points);
  data->SetLines(arrays.lines);
  data->SetPolys(arrays.triangles);
  data->GetPointData()->AddArray(arrays.values);
  data->GetPointData()->AddArray(arrays.colours);
  const auto add_cells = [&](const char* name, vtkNew<vtkIntArray>(&parts)[2]) {
    for (vtkIdType i = 0; i < parts[1]->GetNumberOfTuples(); ++i)
      parts[0]->InsertNextValue(parts[1]->GetValue(i));
    parts[0]->SetName(name);
    data->GetCellData()->AddArray(parts[0]);
  };
  add_cells("quantity", arrays.quantity);
  add_cells("face", arrays.face);
  add_cells("curve", arrays.curve);
  data->GetFieldData()->AddArray(arrays.scales);
  write_atomically(path, vtp_bytes(*data));
}

}  // namespace crest::io
