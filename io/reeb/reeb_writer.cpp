// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reeb/reeb_writer.hpp"

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
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <stdexcept>

#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Vec3;
using reeb::NodePlace;

enum Kind { kNode, kArc, kLevelLine, kTile = 6 };  // between them the trees

int number(Index i) {
  return i == kNone ? -1 : static_cast<int>(i);
}

void add_digest(vtkDataObject& data, const std::string& digest) {
  vtkNew<vtkStringArray> text;
  text->SetName("data_digest");
  text->InsertNextValue(digest);
  data.GetFieldData()->AddArray(text);
}

class PolyBuilder {
 public:
  explicit PolyBuilder(const ReebScene& scene) : scene_(scene) { points_->SetDataTypeToDouble(); }

  std::string bytes() {
    add_nodes();
    add_arcs();
    add_levels();
    add_trees();
    if (!scene_.arc_of_tile.empty()) add_tiles();
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetVerts(verts_);
    data->SetLines(lines_);
    data->SetPolys(polys_);
    data->GetPointData()->AddArray(value_);
    for (const auto& array : {node_, type_, multiplicity_, on_boundary_})
      data->GetPointData()->AddArray(array);
    for (const auto& array : {kind_, arc_, lower_, upper_, face_})
      data->GetCellData()->AddArray(array);
    data->GetCellData()->AddArray(level_);
    add_digest(*data, scene_.data_digest);
    return vtp_bytes(*data);
  }

 private:
  vtkIdType add_point(const Vec3& p, double value, Index node, const reeb::ReebNode* critical) {
    value_->InsertNextValue(value);
    node_->InsertNextValue(number(node));
    type_->InsertNextValue(critical ? static_cast<int>(critical->kind) : -1);
    multiplicity_->InsertNextValue(critical ? static_cast<int>(critical->multiplicity) : 0);
    on_boundary_->InsertNextValue(critical ? critical->on_boundary : 0);
    return points_->InsertNextPoint(p.data());
  }

  void add_cell(int kind, int arc, int lower, int upper, int face, double level) {
    kind_->InsertNextValue(kind);
    arc_->InsertNextValue(arc);
    lower_->InsertNextValue(lower);
    upper_->InsertNextValue(upper);
    face_->InsertNextValue(face);
    level_->InsertNextValue(level);
  }

  void add_nodes() {
    for (const reeb::ReebNode& node : scene_.graph.nodes) {
      const NodePlace& place = scene_.places[node.vertex];
      verts_->InsertNextCell({add_point(place.point, place.value, node.vertex, &node)});
      add_cell(kNode, -1, -1, -1, -1, 0);
    }
  }

  void add_arcs() {
    const auto polylines = arc_polylines(scene_);
    for (std::size_t a = 0; a < polylines.size(); ++a) {
      const reeb::ReebArc& arc = scene_.graph.arcs[a];
      const auto& line = polylines[a];
      lines_->InsertNextCell(static_cast<int>(line.size()));
      lines_->InsertCellPoint(arc.lower);  // the nodes are the first points
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        lines_->InsertCellPoint(add_point(line[i].point, line[i].value, kNone, nullptr));
      lines_->InsertCellPoint(arc.upper);
      add_cell(kArc, static_cast<int>(a), number(arc.lower), number(arc.upper), -1, 0);
    }
  }

  void add_levels() {
    for (const LevelLines& lines : scene_.levels) {
      for (const reeb::Contour& contour : lines.contours) {
        const std::size_t n = contour.points.size();
        lines_->InsertNextCell(static_cast<int>(n + (contour.closed ? 1 : 0)));
        vtkIdType first = 0;
        for (std::size_t i = 0; i < n; ++i) {
          const vtkIdType at = add_point(contour.points[i], lines.level, kNone, nullptr);
          if (i == 0) first = at;
          lines_->InsertCellPoint(at);
        }
        if (contour.closed) lines_->InsertCellPoint(first);
        add_cell(kLevelLine, -1, -1, -1, -1, lines.level);
      }
    }
  }

  void add_trees() {
    for (const TreeLines& tree : scene_.trees) {
      for (const auto& ends : tree.arcs) {
        lines_->InsertNextCell(2);
        for (const Index v : ends) {
          const NodePlace& place = scene_.places[v];
          lines_->InsertCellPoint(add_point(place.point, place.value, v, nullptr));
        }
        add_cell(tree.kind, -1, number(ends[0]), number(ends[1]), -1, 0);
      }
    }
  }

  void add_tiles() {
    const auto first = points_->GetNumberOfPoints();
    for (Index v = 0; v < scene_.places.size(); ++v)
      add_point(scene_.places[v].point, scene_.places[v].value, v, nullptr);
    const auto& tiles = scene_.tiles.tiles;
    const auto& begin = scene_.tiles.tile_begin;
    Index face = 0;
    for (Index t = 0; t < tiles.size(); ++t) {
      while (!begin.empty() && begin[face + 1] <= t) ++face;
      const auto& [a, b, c] = tiles[t];
      polys_->InsertNextCell({first + a, first + b, first + c});
      add_cell(kTile, number(scene_.arc_of_tile[t]), -1, -1, number(begin.empty() ? t : face), 0);
    }
  }

  const ReebScene& scene_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> verts_, lines_, polys_;
  vtkSmartPointer<vtkDoubleArray> value_ = named_doubles("value"), level_ = named_doubles("level");
  vtkSmartPointer<vtkIntArray> node_ = named_ints("node"), type_ = named_ints("type"),
                               multiplicity_ = named_ints("multiplicity"),
                               on_boundary_ = named_ints("on_boundary"), kind_ = named_ints("kind"),
                               arc_ = named_ints("arc"), lower_ = named_ints("lower"),
                               upper_ = named_ints("upper"), face_ = named_ints("face");
};

std::string tiles_vtu(const ReebScene& scene) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto value = named_doubles("value");
  const auto kind = named_ints("kind"), type = named_ints("type"), point_arc = named_ints("arc");
  const std::size_t lines = scene.tiles.vertex_count + scene.tiles.critical_edges.size();
  for (Index v = 0; v < scene.places.size(); ++v) {
    points->InsertNextPoint(scene.places[v].point.data());
    value->InsertNextValue(scene.places[v].value);
    kind->InsertNextValue(v < scene.tiles.vertex_count ? 0 : v < lines ? 1 : 2);
    type->InsertNextValue(-1);
    point_arc->InsertNextValue(number(scene.arc_of_node[v]));
  }
  for (const reeb::ReebNode& node : scene.graph.nodes)
    type->SetValue(node.vertex, static_cast<int>(node.kind));
  vtkNew<vtkCellArray> cells;
  const auto face = named_ints("face"), arc = named_ints("arc");
  const auto& begin = scene.tiles.tile_begin;
  const auto& tiles = scene.tiles.tiles;
  Index f = 0;
  for (Index t = 0; t < tiles.size(); ++t) {
    while (!begin.empty() && begin[f + 1] <= t) ++f;
    cells->InsertNextCell({tiles[t][0], tiles[t][1], tiles[t][2]});
    face->InsertNextValue(number(begin.empty() ? t : f));
    if (!scene.arc_of_tile.empty()) arc->InsertNextValue(number(scene.arc_of_tile[t]));
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->SetCells(VTK_TRIANGLE, cells);
  grid->GetPointData()->AddArray(value);
  for (const auto& array : {kind, type, point_arc}) grid->GetPointData()->AddArray(array);
  grid->GetCellData()->AddArray(face);
  if (!scene.arc_of_tile.empty()) grid->GetCellData()->AddArray(arc);
  add_digest(*grid, scene.data_digest);
  return vtu_bytes(*grid);
}

}  // namespace

std::vector<std::vector<NodePlace>> arc_polylines(const ReebScene& scene, std::size_t parts) {
  const auto& arcs = scene.graph.arcs;
  std::vector<std::size_t> size(arcs.size(), 0), seen(arcs.size(), 0);
  for (const Index a : scene.arc_of_node)
    if (a != kNone) ++size[a];
  struct Mean {
    NodePlace sum{{0, 0, 0}, 0};
    double count = 0;
  };
  std::vector<std::vector<Mean>> groups(arcs.size());
  for (std::size_t a = 0; a < arcs.size(); ++a) groups[a].resize(std::min(size[a], parts));
  for (const Index v : scene.tiles.order) {
    const Index a = scene.arc_of_node[v];
    if (a == kNone) continue;
    Mean& mean = groups[a][seen[a]++ * groups[a].size() / size[a]];
    for (std::size_t k = 0; k < 3; ++k) mean.sum.point[k] += scene.places[v].point[k];
    mean.sum.value += scene.places[v].value;
    ++mean.count;
  }
  std::vector<std::vector<NodePlace>> lines(arcs.size());
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    lines[a].push_back(scene.places[scene.graph.nodes[arcs[a].lower].vertex]);
    for (const Mean& mean : groups[a]) {
      NodePlace place = mean.sum;
      for (double& x : place.point) x /= mean.count;
      place.value /= mean.count;
      lines[a].push_back(place);
    }
    lines[a].push_back(scene.places[scene.graph.nodes[arcs[a].upper].vertex]);
  }
  return lines;
}

void write_reeb(const std::string& path, const ReebScene& scene) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp")
    write_atomically(path, PolyBuilder(scene).bytes());
  else if (extension == ".vtu")
    write_atomically(path, tiles_vtu(scene));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp or .vtu");
}

}  // namespace crest::io
