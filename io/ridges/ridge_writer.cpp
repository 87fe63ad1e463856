// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/ridge_writer.hpp"

#include <fmt/format.h>

#include <array>

#include "io/formats/files.hpp"
#include "io/ridges/ridge_lines.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "io/write/vtk_pieces.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using ridges::Ridge;
using ridges::RidgeGraph;
using ridges::Umbilic;

/// Columns of the point data, the same for every format.
constexpr std::array kPointCodes = {"colour",   "type", "type_third_order", "crossing_type", "kind",
                                    "coherent", "level"};
constexpr std::array kPointNumbers = {"k1",        "k2",           "b",
                                      "P",         "strength",     "sharpness",
                                      "index",     "significance", "crest_significance",
                                      "prominence"};

struct Row {
  kernel::Vec3 point;
  std::array<int, kPointCodes.size()> codes;
  std::array<double, kPointNumbers.size()> numbers;
};

/// Umbilics first, then the ridges' points; lines index into the rows.
struct Table {
  std::vector<Row> rows;
  std::vector<std::vector<Index>> lines;
};

double index_of(const Umbilic& umbilic) {
  return 0.5 * umbilic.twice_index;
}

Row umbilic_row(const kernel::TriangleMesh& mesh, const ridges::FitResult& fit,
                const Umbilic& umbilic) {
  double k1 = 0, k2 = 0;
  for (Index v : mesh.faces()[umbilic.face]) {
    k1 += fit.forms[v].k1 / 3;
    k2 += fit.forms[v].k2 / 3;
  }
  return {umbilic.point,
          {-1, -1, -1, -1, static_cast<int>(umbilic.kind), umbilic.coherent ? 1 : 0, umbilic.level},
          {k1, k2, 0, 0, 0, 0, index_of(umbilic), 0, 0, 0}};
}

Row ridge_row(const Ridge& ridge, const LinePoint& p) {
  Row row{p.point,
          {static_cast<int>(ridge.colour), static_cast<int>(p.fourth_order),
           static_cast<int>(p.third_order), -1, -1, -1, p.level},
          {0, 0, 0, 0, ridge.strength, ridge.sharpness, 0, 0, 0, 0}};
  if (p.crossing != nullptr) {
    row.codes[3] = static_cast<int>(p.crossing->type);
    row.numbers[0] = p.crossing->k1;
    row.numbers[1] = p.crossing->k2;
    row.numbers[2] = p.crossing->b;
    row.numbers[3] = p.crossing->p;
    row.numbers[7] = p.crossing->significance;
    row.numbers[8] = p.crossing->crest_significance;
    row.numbers[9] = p.crossing->prominence;
  }
  return row;
}

Table table_of(const kernel::TriangleMesh& mesh, const ridges::FitResult& fit,
               const RidgeGraph& graph) {
  Table table;
  for (const Umbilic& umbilic : graph.umbilics)
    table.rows.push_back(umbilic_row(mesh, fit, umbilic));
  for (const Ridge& ridge : graph.ridges) {
    std::vector<Index> line;
    for (const LinePoint& p : line_points(ridge)) {
      line.push_back(static_cast<Index>(table.rows.size()));
      table.rows.push_back(ridge_row(ridge, p));
    }
    if (ridge.loop && !line.empty()) line.push_back(line.front());
    table.lines.push_back(std::move(line));
  }
  return table;
}

int umbilic_id(const ridges::RidgeEnd& end) {
  return end.kind == ridges::EndKind::umbilic ? static_cast<int>(end.umbilic) : -1;
}

struct Cell {
  const Ridge* ridge = nullptr;      ///< of a polyline
  const Umbilic* umbilic = nullptr;  ///< of a vertex
  int number = -1;                   ///< the umbilic's
};

void add_row(Columns& cells, const Cell& cell) {
  const Ridge* r = cell.ridge;
  const Umbilic* u = cell.umbilic;
  cells.add("colour", r ? static_cast<int>(r->colour) : -1);
  cells.add("loop", r ? static_cast<int>(r->loop) : -1);
  cells.add("end_kind_0", r ? static_cast<int>(r->ends[0].kind) : -1);
  cells.add("end_kind_1", r ? static_cast<int>(r->ends[1].kind) : -1);
  cells.add("end_umbilic_0", r ? umbilic_id(r->ends[0]) : -1);
  cells.add("end_umbilic_1", r ? umbilic_id(r->ends[1]) : -1);
  cells.add("length", r ? r->length : 0.0);
  cells.add("strength", r ? r->strength : 0.0);
  cells.add("sharpness", r ? r->sharpness : 0.0);
  cells.add("weight", r ? r->weight : 0.0);
  cells.add("umbilic", cell.number);
  cells.add("kind", u ? static_cast<int>(u->kind) : -1);
  cells.add("coherent", u ? static_cast<int>(u->coherent) : -1);
  cells.add("index", u ? index_of(*u) : 0.0);
}

vtkSmartPointer<vtkPolyData> data_of(const Table& table, const RidgeGraph& graph,
                                     const std::string& digest, const ridges::FitResult& fit) {
  PolyData data;
  Columns& points = data.point_rows();
  for (const Row& row : table.rows) {
    data.add_point(row.point);
    for (std::size_t i = 0; i < kPointCodes.size(); ++i) points.add(kPointCodes[i], row.codes[i]);
    for (std::size_t i = 0; i < kPointNumbers.size(); ++i)
      points.add(kPointNumbers[i], row.numbers[i]);
  }
  for (std::size_t i = 0; i < graph.umbilics.size(); ++i) {
    add_row(data.add_vertex(static_cast<PolyData::Id>(i)),
            {nullptr, &graph.umbilics[i], static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < graph.ridges.size(); ++i) {
    const std::vector<PolyData::Id> line(table.lines[i].begin(), table.lines[i].end());
    add_row(data.add_line(line), {&graph.ridges[i], nullptr, -1});
  }
  data.fields().add("data_digest", digest);
  data.fields().add("fit_scale", fit.scale);
  data.fields().add("fit_points", fit.points);
  return data.data();
}

std::string obj_of(const Table& table, const RidgeGraph& graph, const std::string& digest) {
  Text text;
  text.add("# ridges and umbilics, data digest {}\n", digest);
  for (const Row& row : table.rows)
    text.add("v {} {} {}\n", row.point[0], row.point[1], row.point[2]);
  if (!graph.umbilics.empty()) text.add("g umbilics\n");
  for (std::size_t i = 0; i < graph.umbilics.size(); ++i) text.add("p {}\n", i + 1);
  for (const auto colour : {ridges::Colour::blue, ridges::Colour::red}) {
    text.add("g {}\n", colour == ridges::Colour::blue ? "blue" : "red");
    for (std::size_t i = 0; i < graph.ridges.size(); ++i) {
      if (graph.ridges[i].colour != colour) continue;
      text.add("{}", table.lines[i].size() == 1 ? 'p' : 'l');
      for (Index p : table.lines[i]) text.add(" {}", p + 1);
      text.add("\n");
    }
  }
  return text.text();
}

std::string ply_of(const Table& table, const std::string& digest) {
  std::size_t edges = 0;
  for (const auto& line : table.lines) edges += line.empty() ? 0 : line.size() - 1;
  Text text;
  text.add("ply\nformat ascii 1.0\ncomment data_digest {}\nelement vertex {}\n", digest,
           table.rows.size());
  for (const char* name : {"x", "y", "z"}) text.add("property double {}\n", name);
  for (const char* name : kPointCodes) text.add("property int {}\n", name);
  for (const char* name : kPointNumbers) text.add("property double {}\n", name);
  text.add("element edge {}\n", edges);
  for (const char* name : {"vertex1", "vertex2", "colour", "type"})
    text.add("property int {}\n", name);
  text.add("end_header\n");
  for (const Row& row : table.rows) {
    text.add("{} {} {} {} {}\n", row.point[0], row.point[1], row.point[2],
             fmt::join(row.codes, " "), fmt::join(row.numbers, " "));
  }
  for (const auto& line : table.lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Row& row = table.rows[line[i]];
      text.add("{} {} {} {}\n", line[i], line[i + 1], row.codes[0], row.codes[1]);
    }
  }
  return text.text();
}

}  // namespace

vtkSmartPointer<vtkPolyData> ridge_poly_data(const kernel::TriangleMesh& mesh,
                                             const ridges::FitResult& fit, const RidgeGraph& graph,
                                             const std::string& data_digest_hex) {
  return data_of(table_of(mesh, fit, graph), graph, data_digest_hex, fit);
}

void write_ridges(const std::string& path, const kernel::TriangleMesh& mesh,
                  const ridges::FitResult& fit, const RidgeGraph& graph,
                  const std::string& data_digest_hex) {
  const std::string extension = lower_extension(path);
  const Table table = table_of(mesh, fit, graph);
  if (extension == ".vtp")
    write_vtp(path, *data_of(table, graph, data_digest_hex, fit));
  else if (extension == ".pvtp")
    write_pvtp(path, *data_of(table, graph, data_digest_hex, fit));
  else if (extension == ".obj")
    write_atomically(path, obj_of(table, graph, data_digest_hex));
  else if (extension == ".ply")
    write_atomically(path, ply_of(table, data_digest_hex));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp .pvtp .obj .ply");
}

}  // namespace crest::io
