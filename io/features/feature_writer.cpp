// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/features/feature_writer.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <array>
#include <iterator>

#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using feature_lines::FeatureGraph;
using feature_lines::FeatureLine;
using feature_lines::Label;
using feature_lines::LineKind;
using kernel::Index;
using kernel::kNone;

int code(Label label) {
  return static_cast<int>(label);
}

int code(LineKind kind) {
  constexpr std::array labels = {Label::arc, Label::branch, Label::loop, Label::isolated};
  return code(labels[static_cast<std::size_t>(kind)]);
}

int id(Index n) {
  return n == kNone ? -1 : static_cast<int>(n);
}

void add_points(vtkPolyData& data, const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
                const std::vector<double>& field) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto label = named_ints("label"), patch = named_ints("patch");
  const auto value = named_doubles("field");
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    points->InsertNextPoint(mesh.points()[v].data());
    label->InsertNextValue(code(graph.labels[v]));
    patch->InsertNextValue(id(graph.patch_of[v]));
    value->InsertNextValue(field[v]);
  }
  data.SetPoints(points);
  data.GetPointData()->AddArray(label);
  data.GetPointData()->AddArray(patch);
  data.GetPointData()->AddArray(value);
}

/// The columns of the cell data.
struct CellColumns {
  vtkSmartPointer<vtkIntArray> kind = named_ints("kind"), end_0 = named_ints("end_0"),
                               end_1 = named_ints("end_1"), node_0 = named_ints("node_0"),
                               node_1 = named_ints("node_1"), patch = named_ints("patch");
  vtkSmartPointer<vtkDoubleArray> length = named_doubles("length");

  void add(int k, std::array<int, 2> ends, std::array<int, 2> nodes, int p, double l) {
    kind->InsertNextValue(k);
    end_0->InsertNextValue(ends[0]);
    end_1->InsertNextValue(ends[1]);
    node_0->InsertNextValue(nodes[0]);
    node_1->InsertNextValue(nodes[1]);
    patch->InsertNextValue(p);
    length->InsertNextValue(l);
  }
  void move_to(vtkPolyData& data) const {
    for (const auto& array : {kind, end_0, end_1, node_0, node_1, patch})
      data.GetCellData()->AddArray(array);
    data.GetCellData()->AddArray(length);
  }
};

void add_lines(vtkPolyData& data, const FeatureGraph& graph, CellColumns& columns) {
  vtkNew<vtkCellArray> lines;
  for (const FeatureLine& line : graph.lines) {
    const bool loop = line.kind == LineKind::loop;
    lines->InsertNextCell(static_cast<int>(line.vertices.size() + (loop ? 1 : 0)));
    for (const Index v : line.vertices) lines->InsertCellPoint(v);
    if (loop) lines->InsertCellPoint(line.vertices.front());
    columns.add(code(line.kind), {static_cast<int>(line.ends[0]), static_cast<int>(line.ends[1])},
                {id(line.nodes[0]), id(line.nodes[1])}, -1, line.length);
  }
  for (const auto& [v, w] : graph.node_edges) {
    lines->InsertNextCell({v, w});
    columns.add(code(Label::node), {-1, -1}, {-1, -1}, -1, 0);
  }
  data.SetLines(lines);
}

void add_faces(vtkPolyData& data, const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
               CellColumns& columns) {
  vtkNew<vtkCellArray> faces;
  for (const kernel::Triangle& f : mesh.faces()) {
    faces->InsertNextCell({f[0], f[1], f[2]});
    int patch = -1;
    for (std::size_t k = 3; k-- > 0;) patch = std::max(patch, id(graph.patch_of[f[k]]));
    columns.add(0, {-1, -1}, {-1, -1}, patch, 0);
  }
  data.SetPolys(faces);
}

std::string vtp_of(const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
                   const std::vector<double>& field, const std::string& digest) {
  vtkNew<vtkPolyData> data;
  add_points(*data, mesh, graph, field);
  CellColumns columns;
  add_lines(*data, graph, columns);
  add_faces(*data, mesh, graph, columns);
  columns.move_to(*data);
  vtkNew<vtkStringArray> text;
  text->SetName("data_digest");
  text->InsertNextValue(digest);
  data->GetFieldData()->AddArray(text);
  return vtp_bytes(*data);
}

std::string obj_of(const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
                   const std::string& digest) {
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "# feature lines, data digest {}\n", digest);
  std::vector<Index> number(mesh.vertex_count(), 0);
  Index used = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (graph.labels[v] == Label::patch) continue;
    number[v] = ++used;
    const auto& p = mesh.points()[v];
    fmt::format_to(out, "v {} {} {}\n", p[0], p[1], p[2]);
  }
  constexpr std::array names = {"arcs", "branches", "loops", "isolated_lines"};
  for (std::size_t kind = 0; kind < names.size(); ++kind) {
    fmt::format_to(out, "g {}\n", names[kind]);
    for (const FeatureLine& line : graph.lines) {
      if (static_cast<std::size_t>(line.kind) != kind || line.vertices.size() < 2) continue;
      fmt::format_to(out, "l");
      for (const Index v : line.vertices) fmt::format_to(out, " {}", number[v]);
      if (line.kind == LineKind::loop) fmt::format_to(out, " {}", number[line.vertices.front()]);
      fmt::format_to(out, "\n");
    }
  }
  fmt::format_to(out, "g nodes\n");
  for (const auto& [v, w] : graph.node_edges)
    fmt::format_to(out, "l {} {}\n", number[v], number[w]);
  return fmt::to_string(text);
}

}  // namespace

void write_features(const std::string& path, const kernel::TriangleMesh& mesh,
                    const FeatureGraph& graph, const std::vector<double>& field,
                    const std::string& data_digest_hex) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp")
    write_atomically(path, vtp_of(mesh, graph, field, data_digest_hex));
  else if (extension == ".obj")
    write_atomically(path, obj_of(mesh, graph, data_digest_hex));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp or .obj");
}

}  // namespace crest::io
