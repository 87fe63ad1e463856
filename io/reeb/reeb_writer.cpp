// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reeb/reeb_writer.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

#include "io/formats/files.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
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

/// What the file calls it.
int face_number(const ReebScene& scene, Index face) {
  return scene.face_numbers.empty() ? number(face) : static_cast<int>(scene.face_numbers[face]);
}

class Rows {
 public:
  explicit Rows(const ReebScene& scene) : scene_(scene) {}

  vtkSmartPointer<vtkPolyData> data() {
    add_nodes();
    add_arcs();
    add_levels();
    add_trees();
    if (!scene_.arc_of_tile.empty()) add_tiles();
    data_.fields().add("data_digest", scene_.data_digest);
    return data_.data();
  }

 private:
  PolyData::Id add_point(const Vec3& p, double value, Index node, const reeb::ReebNode* critical) {
    Columns& row = data_.point_rows();
    row.add("value", value);
    row.add("node", number(node));
    row.add("type", critical ? static_cast<int>(critical->kind) : -1);
    row.add("multiplicity", critical ? static_cast<int>(critical->multiplicity) : 0);
    row.add("on_boundary", critical ? int{critical->on_boundary} : 0);
    return data_.add_point(p);
  }

  static void add_row(Columns& row, int kind, int arc, int lower, int upper, int face,
                      double level) {
    row.add("kind", kind);
    row.add("arc", arc);
    row.add("lower", lower);
    row.add("upper", upper);
    row.add("face", face);
    row.add("level", level);
  }

  void add_nodes() {
    for (const reeb::ReebNode& node : scene_.graph.nodes) {
      const NodePlace& place = scene_.places[node.vertex];
      const auto point = add_point(place.point, place.value, node.vertex, &node);
      add_row(data_.add_vertex(point), kNode, -1, -1, -1, -1, 0);
    }
  }

  void add_arcs() {
    const auto polylines = arc_polylines(scene_);
    for (std::size_t a = 0; a < polylines.size(); ++a) {
      const reeb::ReebArc& arc = scene_.graph.arcs[a];
      const auto& places = polylines[a];
      std::vector<PolyData::Id> line{arc.lower};  // the nodes are the first points
      for (std::size_t i = 1; i + 1 < places.size(); ++i)
        line.push_back(add_point(places[i].point, places[i].value, kNone, nullptr));
      line.push_back(arc.upper);
      add_row(data_.add_line(line), kArc, static_cast<int>(a), number(arc.lower), number(arc.upper),
              -1, 0);
    }
  }

  void add_levels() {
    for (const LevelLines& lines : scene_.levels) {
      for (const reeb::Contour& contour : lines.contours) {
        std::vector<PolyData::Id> line;
        for (const Vec3& p : contour.points)
          line.push_back(add_point(p, lines.level, kNone, nullptr));
        if (contour.closed) line.push_back(line.front());
        add_row(data_.add_line(line), kLevelLine, -1, -1, -1, -1, lines.level);
      }
    }
  }

  void add_trees() {
    for (const TreeLines& tree : scene_.trees) {
      for (const auto& ends : tree.arcs) {
        std::vector<PolyData::Id> line;
        for (const Index v : ends)
          line.push_back(add_point(scene_.places[v].point, scene_.places[v].value, v, nullptr));
        add_row(data_.add_line(line), tree.kind, -1, number(ends[0]), number(ends[1]), -1, 0);
      }
    }
  }

  void add_tiles() {
    const PolyData::Id first = data_.point_count();
    for (Index v = 0; v < scene_.places.size(); ++v)
      add_point(scene_.places[v].point, scene_.places[v].value, v, nullptr);
    const auto& tiles = scene_.tiles.tiles;
    const auto& begin = scene_.tiles.tile_begin;
    Index face = 0;
    for (Index t = 0; t < tiles.size(); ++t) {
      while (!begin.empty() && begin[face + 1] <= t) ++face;
      const auto& [a, b, c] = tiles[t];
      add_row(data_.add_triangle(first + a, first + b, first + c), kTile,
              number(scene_.arc_of_tile[t]), -1, -1, face_number(scene_, begin.empty() ? t : face),
              0);
    }
  }

  const ReebScene& scene_;
  PolyData data_;
};

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> reeb_tiles(const ReebScene& scene) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<int> type(scene.places.size(), -1);
  for (const reeb::ReebNode& node : scene.graph.nodes)
    type[node.vertex] = static_cast<int>(node.kind);
  Columns point_rows, cell_rows, fields;
  const std::size_t lines = scene.tiles.vertex_count + scene.tiles.critical_edges.size();
  for (Index v = 0; v < scene.places.size(); ++v) {
    points->InsertNextPoint(scene.places[v].point.data());
    point_rows.add("value", scene.places[v].value);
    point_rows.add("kind", v < scene.tiles.vertex_count ? 0 : v < lines ? 1 : 2);
    point_rows.add("type", type[v]);
    point_rows.add("arc", number(scene.arc_of_node[v]));
  }
  vtkNew<vtkCellArray> cells;
  const auto& begin = scene.tiles.tile_begin;
  const auto& tiles = scene.tiles.tiles;
  Index f = 0;
  for (Index t = 0; t < tiles.size(); ++t) {
    while (!begin.empty() && begin[f + 1] <= t) ++f;
    cells->InsertNextCell({tiles[t][0], tiles[t][1], tiles[t][2]});
    cell_rows.add("face", face_number(scene, begin.empty() ? t : f));
    if (!scene.arc_of_tile.empty()) cell_rows.add("arc", number(scene.arc_of_tile[t]));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TRIANGLE, cells);
  fields.add("data_digest", scene.data_digest);
  point_rows.move_to(*grid->GetPointData());
  cell_rows.move_to(*grid->GetCellData());
  fields.move_to(*grid->GetFieldData());
  return grid;
}

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
  double reach = 0;
  for (const NodePlace& place : scene.places)
    for (const double x : {place.point[0], place.point[1], place.point[2], place.value})
      reach = std::max(reach, std::fabs(x));
  const double unit = reach > 1e290 ? 0x1p-40 : 1;  // sums stay in range; exact
  for (const Index v : scene.tiles.order) {
    const Index a = scene.arc_of_node[v];
    if (a == kNone) continue;
    Mean& mean = groups[a][seen[a]++ * groups[a].size() / size[a]];
    for (std::size_t k = 0; k < 3; ++k) mean.sum.point[k] += unit * scene.places[v].point[k];
    mean.sum.value += unit * scene.places[v].value;
    ++mean.count;
  }
  std::vector<std::vector<NodePlace>> lines(arcs.size());
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    lines[a].push_back(scene.places[scene.graph.nodes[arcs[a].lower].vertex]);
    for (const Mean& mean : groups[a]) {
      NodePlace place = mean.sum;
      for (double& x : place.point) x = x / mean.count / unit;
      place.value = place.value / mean.count / unit;
      lines[a].push_back(place);
    }
    lines[a].push_back(scene.places[scene.graph.nodes[arcs[a].upper].vertex]);
  }
  return lines;
}

vtkSmartPointer<vtkPolyData> reeb_poly_data(const ReebScene& scene) {
  return Rows(scene).data();
}

void write_reeb(const std::string& path, const ReebScene& scene) {
  const std::string extension = lower_extension(path);
  if (extension == ".vtp")
    write_vtp(path, *reeb_poly_data(scene));
  else if (extension == ".vtu")
    write_vtu(path, *reeb_tiles(scene));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp or .vtu");
}

}  // namespace crest::io
