// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/smooth_ridge_writer.hpp"

#include <fmt/format.h>

#include <array>

#include "io/formats/files.hpp"
#include "io/ridges/smooth_ridge_lines.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/mesh_writer.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Colour;
using kernel::Index;
using kernel::RidgeType;
using smooth_ridges::SmoothRidge;
using smooth_ridges::SmoothRidges;

/// Columns of points and cells, the same for every format.
constexpr std::array kCodes = {"kind",        "colour",        "type",
                               "twice_index", "blue_branches", "red_branches"};
constexpr std::array kNumbers = {"index", "size"};

/// What a point or cell is.
struct SmoothRow {
  std::array<int, kCodes.size()> codes{kRidgePart, -1, -1, 0, 0, 0};
  std::array<double, kNumbers.size()> numbers{};
  void add_to(Columns& columns) const {
    for (std::size_t i = 0; i < kCodes.size(); ++i) columns.add(kCodes[i], codes[i]);
    for (std::size_t i = 0; i < kNumbers.size(); ++i) columns.add(kNumbers[i], numbers[i]);
  }
};

struct Point {
  kernel::Vec3 place;
  SmoothRow row;
};

/// Vertices first (umbilics, turning points, purple points, undecided cells), then the ridges'
/// points; lines index into the points.
struct SmoothTable {
  std::vector<Point> points;
  std::array<std::size_t, 4> vertices{};  ///< how many of each
  std::vector<Index> first;               ///< of each ridge's points
};

SmoothRow ridge_row(const SmoothRidge& ridge, RidgeType type) {
  return {{kRidgePart, static_cast<int>(ridge.colour), static_cast<int>(type), 0, 0, 0}, {}};
}

void add_vertices(const SmoothRidges& result, SmoothTable& table) {
  for (const auto& u : result.umbilics) {
    table.points.push_back({u.point,
                            {{u.branches[0], -1, -1, u.twice_index, u.branches[0], u.branches[1]},
                             {0.5 * u.twice_index, 0}}});
  }
  for (const auto& p : result.turning_points) {
    table.points.push_back(
        {p.point, {{kTurningPoint, static_cast<int>(p.colour), -1, 0, 0, 0}, {}}});
  }
  for (const auto& p : result.purple_points)
    table.points.push_back({p.point, {{kPurplePoint, -1, -1, 0, 0, 0}, {}}});
  for (const auto& c : result.undecided)
    table.points.push_back({c.centre, {{kUndecidedCell, -1, -1, 0, 0, 0}, {0, c.size}}});
  table.vertices = {result.umbilics.size(), result.turning_points.size(),
                    result.purple_points.size(), result.undecided.size()};
}

SmoothTable table_of(const SmoothRidges& result) {
  SmoothTable table;
  add_vertices(result, table);
  for (const SmoothRidge& ridge : result.ridges) {
    table.first.push_back(static_cast<Index>(table.points.size()));
    const std::vector<RidgeType> types = drawn_types(ridge);
    for (std::size_t i = 0; i < ridge.points.size(); ++i) {
      const RidgeType type = types.empty() ? RidgeType::none : types[std::min(i, types.size() - 1)];
      table.points.push_back({ridge.points[i], ridge_row(ridge, type)});
    }
  }
  return table;
}

/// What the cells of whole ridges and umbilics say beyond their row.
void add_ridge_columns(Columns& cells, const SmoothRidges& result, std::size_t number,
                       const RidgeRun& run) {
  const SmoothRidge& ridge = result.ridges[number];
  double length = 0;
  for (std::size_t i = 0; i + 1 < run.points.size(); ++i)
    length += length_of(ridge, run.points[i], run.points[i + 1]);
  const auto umbilic = [&](std::size_t end) {
    return ridge.ends[end] == kernel::kNone ? -1 : static_cast<int>(ridge.ends[end]);
  };
  cells.add("ridge", static_cast<int>(number));
  cells.add("loop", ridge.loop ? 1 : 0);
  cells.add("end_kind_0", end_kind(result, ridge, 0));
  cells.add("end_kind_1", end_kind(result, ridge, 1));
  cells.add("end_umbilic_0", umbilic(0));
  cells.add("end_umbilic_1", umbilic(1));
  cells.add("umbilic", -1);
  cells.add("length", length);
}

void add_vertex_columns(Columns& cells, int umbilic) {
  for (const char* name :
       {"ridge", "loop", "end_kind_0", "end_kind_1", "end_umbilic_0", "end_umbilic_1"})
    cells.add(name, -1);
  cells.add("umbilic", umbilic);
  cells.add("length", 0.0);
}

void add_fields(Columns& fields, const SmoothRidges& result, const std::string& digest) {
  fields.add("certified", result.certified ? 1 : 0);
  fields.add("undecided", static_cast<int>(result.undecided.size()));
  fields.add("data_digest", digest);
}

vtkSmartPointer<vtkPolyData> data_of(const SmoothTable& table, const SmoothRidges& result,
                                     const std::string& digest) {
  PolyData data;
  for (const Point& p : table.points) {
    data.add_point(p.place);
    p.row.add_to(data.point_rows());
  }
  const std::size_t count =
      table.vertices[0] + table.vertices[1] + table.vertices[2] + table.vertices[3];
  for (std::size_t i = 0; i < count; ++i) {
    Columns& row = data.add_vertex(static_cast<PolyData::Id>(i));
    table.points[i].row.add_to(row);
    add_vertex_columns(row, i < table.vertices[0] ? static_cast<int>(i) : -1);
  }
  for (std::size_t r = 0; r < result.ridges.size(); ++r) {
    for (const RidgeRun& run : runs_of(result.ridges[r])) {
      std::vector<PolyData::Id> line;
      for (const std::size_t p : run.points)
        line.push_back(table.first[r] + static_cast<PolyData::Id>(p));
      Columns& row = data.add_line(line);
      ridge_row(result.ridges[r], run.type).add_to(row);
      add_ridge_columns(row, result, r, run);
    }
  }
  add_fields(data.fields(), result, digest);
  return data.data();
}

/// The line of text that goes before everything else.
std::string headline(const SmoothRidges& result, const std::string& digest) {
  if (result.certified)
    return fmt::format("ridges and umbilics, certified, data digest {}", digest);
  return fmt::format("ridges and umbilics, NOT CERTIFIED, {} undecided cells",
                     result.undecided.size());
}

/// The ridge's points in the table, a loop's first one again at its end.
std::vector<std::size_t> line_of(const SmoothTable& table, const SmoothRidges& result,
                                 std::size_t r) {
  std::vector<std::size_t> line;
  for (std::size_t i = 0; i < result.ridges[r].points.size(); ++i)
    line.push_back(table.first[r] + i);
  if (result.ridges[r].loop && !line.empty()) line.push_back(line.front());
  return line;
}

std::string obj_of(const SmoothTable& table, const SmoothRidges& result,
                   const std::string& digest) {
  Text text;
  text.add("# {}\n", headline(result, digest));
  for (const Point& p : table.points) text.add("v {} {} {}\n", p.place[0], p.place[1], p.place[2]);
  std::size_t next = 1;
  constexpr std::array groups = {"umbilics", "turning_points", "purple_points", "undecided_cells"};
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (table.vertices[g] > 0) text.add("g {}\n", groups[g]);
    for (std::size_t i = 0; i < table.vertices[g]; ++i) text.add("p {}\n", next++);
  }
  for (const Colour colour : {Colour::blue, Colour::red}) {
    text.add("g {}\n", colour == Colour::blue ? "blue" : "red");
    for (std::size_t r = 0; r < result.ridges.size(); ++r) {
      const std::vector<std::size_t> line = line_of(table, result, r);
      if (result.ridges[r].colour != colour || line.empty()) continue;
      text.add("{}", line.size() == 1 ? 'p' : 'l');
      for (const std::size_t p : line) text.add(" {}", p + 1);
      text.add("\n");
    }
  }
  return text.text();
}

std::string ply_of(const SmoothTable& table, const SmoothRidges& result,
                   const std::string& digest) {
  Text text, edges;
  std::size_t edge_count = 0;
  for (std::size_t r = 0; r < result.ridges.size(); ++r) {
    const std::vector<std::size_t> line = line_of(table, result, r);
    for (std::size_t i = 0; i + 1 < line.size(); ++i, ++edge_count) {
      const SmoothRow& row = table.points[line[i]].row;
      edges.add("{} {} {} {}\n", line[i], line[i + 1], row.codes[1], row.codes[2]);
    }
  }
  text.add("ply\nformat ascii 1.0\ncomment {}\nelement vertex {}\n", headline(result, digest),
           table.points.size());
  for (const char* name : {"x", "y", "z"}) text.add("property double {}\n", name);
  for (const char* name : kCodes) text.add("property int {}\n", name);
  for (const char* name : kNumbers) text.add("property double {}\n", name);
  text.add("element edge {}\n", edge_count);
  for (const char* name : {"vertex1", "vertex2", "colour", "type"})
    text.add("property int {}\n", name);
  text.add("end_header\n");
  for (const Point& p : table.points) {
    text.add("{} {} {} {} {}\n", p.place[0], p.place[1], p.place[2], fmt::join(p.row.codes, " "),
             fmt::join(p.row.numbers, " "));
  }
  text.add(edges);
  return text.text();
}

}  // namespace

vtkSmartPointer<vtkPolyData> smooth_ridge_poly_data(const SmoothRidges& result,
                                                    const std::string& data_digest_hex) {
  return data_of(table_of(result), result, data_digest_hex);
}

vtkSmartPointer<vtkPolyData> smooth_mesh_poly_data(const SmoothRidges& result,
                                                   const std::string& data_digest_hex) {
  PolyData data;
  data.add_points(result.points);
  const std::vector<bool> undecided = undecided_faces(result);
  for (std::size_t f = 0; f < result.faces.size(); ++f) {
    const kernel::Triangle& t = result.faces[f];
    Columns& row = data.add_triangle(t[0], t[1], t[2]);
    row.add("in_patch", result.in_patch[f] ? 1 : 0);
    row.add("undecided", undecided[f] ? 1 : 0);
  }
  add_fields(data.fields(), result, data_digest_hex);
  return data.data();
}

void write_smooth_ridges(const std::string& path, const SmoothRidges& result,
                         const std::string& data_digest_hex) {
  const std::string extension = lower_extension(path);
  const SmoothTable table = table_of(result);
  if (extension == ".vtp")
    write_vtp(path, *data_of(table, result, data_digest_hex));
  else if (extension == ".obj")
    write_atomically(path, obj_of(table, result, data_digest_hex));
  else if (extension == ".ply")
    write_atomically(path, ply_of(table, result, data_digest_hex));
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp .obj .ply");
}

void write_smooth_mesh(const std::string& path, const SmoothRidges& result,
                       const std::string& data_digest_hex) {
  if (lower_extension(path) == ".vtp")
    write_vtp(path, *smooth_mesh_poly_data(result, data_digest_hex));
  else
    write_mesh(path, result.points, result.faces);
}

}  // namespace crest::io
