// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/features/feature_writer.hpp"

#include <array>

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
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

void add_points(PolyData& data, const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
                const std::vector<double>& field) {
  data.add_points(mesh.points());
  Columns& rows = data.point_rows();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    rows.add("label", code(graph.labels[v]));
    rows.add("patch", id(graph.patch_of[v]));
    rows.add("field", field[v]);
  }
}

void add_row(Columns& rows, int kind, std::array<int, 2> ends, std::array<int, 2> nodes, int patch,
             double length) {
  rows.add("kind", kind);
  rows.add("end_0", ends[0]);
  rows.add("end_1", ends[1]);
  rows.add("node_0", nodes[0]);
  rows.add("node_1", nodes[1]);
  rows.add("patch", patch);
  rows.add("length", length);
}

void add_lines(PolyData& data, const FeatureGraph& graph) {
  for (const FeatureLine& line : graph.lines) {
    std::vector<PolyData::Id> points(line.vertices.begin(), line.vertices.end());
    if (line.kind == LineKind::loop) points.push_back(points.front());
    add_row(data.add_line(points), code(line.kind),
            {static_cast<int>(line.ends[0]), static_cast<int>(line.ends[1])},
            {id(line.nodes[0]), id(line.nodes[1])}, -1, line.length);
  }
  for (const auto& [v, w] : graph.node_edges)
    add_row(data.add_line(std::array<PolyData::Id, 2>{v, w}), code(Label::node), {-1, -1}, {-1, -1},
            -1, 0);
}

void add_faces(PolyData& data, const kernel::TriangleMesh& mesh, const FeatureGraph& graph) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.faces()[f];
    add_row(data.add_triangle(a, b, c), 0, {-1, -1}, {-1, -1}, id(graph.face_patch[f]), 0);
  }
}

std::string obj_of(const kernel::TriangleMesh& mesh, const FeatureGraph& graph,
                   const std::string& digest) {
  Text text;
  text.add("# feature lines, data digest {}\n", digest);
  std::vector<Index> number(mesh.vertex_count(), 0);
  Index used = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (graph.labels[v] == Label::patch) continue;
    number[v] = ++used;
    const auto& p = mesh.points()[v];
    text.add("v {} {} {}\n", p[0], p[1], p[2]);
  }
  constexpr std::array names = {"arcs", "branches", "loops", "isolated_lines"};
  for (std::size_t kind = 0; kind < names.size(); ++kind) {
    text.add("g {}\n", names[kind]);
    for (const FeatureLine& line : graph.lines) {
      if (static_cast<std::size_t>(line.kind) != kind) continue;
      text.add("{}", line.vertices.size() == 1 ? 'p' : 'l');
      for (const Index v : line.vertices) text.add(" {}", number[v]);
      if (line.kind == LineKind::loop) text.add(" {}", number[line.vertices.front()]);
      text.add("\n");
    }
  }
  text.add("g nodes\n");
  for (const auto& [v, w] : graph.node_edges) text.add("l {} {}\n", number[v], number[w]);
  return text.text();
}

vtkSmartPointer<vtkPolyData> patches_data(const kernel::TriangleMesh& mesh,
                                          const std::vector<Index>& face_patch) {
  PolyData data;
  data.add_points(mesh.points());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.faces()[f];
    data.add_triangle(a, b, c).add("patch", id(face_patch[f]));
  }
  return data.data();
}

std::string patches_ply(const kernel::TriangleMesh& mesh, const std::vector<Index>& face_patch) {
  Text text;
  text.add(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "property int patch\nend_header\n",
      mesh.vertex_count(), mesh.face_count());
  for (const kernel::Vec3& p : mesh.points()) text.add("{} {} {}\n", p[0], p[1], p[2]);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.faces()[f];
    text.add("3 {} {} {} {}\n", a, b, c, id(face_patch[f]));
  }
  return text.text();
}

}  // namespace

void write_patches(const std::string& path, const kernel::TriangleMesh& mesh,
                   const std::vector<Index>& face_patch) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp")
    write_vtp(path, *patches_data(mesh, face_patch));
  else if (extension == ".ply")
    write_atomically(path, patches_ply(mesh, face_patch));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp or .ply");
}

vtkSmartPointer<vtkPolyData> feature_poly_data(const kernel::TriangleMesh& mesh,
                                               const FeatureGraph& graph,
                                               const std::vector<double>& field,
                                               const std::string& data_digest_hex) {
  PolyData data;
  add_points(data, mesh, graph, field);
  add_lines(data, graph);
  add_faces(data, mesh, graph);
  data.fields().add("data_digest", data_digest_hex);
  return data.data();
}

void write_features(const std::string& path, const kernel::TriangleMesh& mesh,
                    const FeatureGraph& graph, const std::vector<double>& field,
                    const std::string& data_digest_hex) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp")
    write_vtp(path, *feature_poly_data(mesh, graph, field, data_digest_hex));
  else if (extension == ".obj")
    write_atomically(path, obj_of(mesh, graph, data_digest_hex));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp or .obj");
}

}  // namespace crest::io
