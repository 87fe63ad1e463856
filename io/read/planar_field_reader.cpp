// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/planar_field_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/net_cdf.hpp"
#include "io/read/plane_grid.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::Vec2;
using Node = Cells::Node;

/// Collects triangles by the file's points.
class Triangles {
 public:
  explicit Triangles(const Soup& soup) : soup_(soup) {
    for (std::size_t c = 0; c < soup.cells.size(); ++c) add_cell(c);
    if (triangles.empty())
      fail("cells", "none is a triangle or quadrilateral", "give a plane mesh");
    if (left_out_ > 0)
      warnings.push_back(
          fmt::format("{} cells that are no triangles or quadrilaterals left out", left_out_));
    if (quads_ > 0)
      warnings.push_back(fmt::format("{} quadrilaterals split along the shorter diagonal", quads_));
  }

  std::vector<std::array<Node, 3>> triangles;
  std::vector<std::int64_t> cell_of;
  std::vector<std::string> warnings;

 private:
  void add(std::size_t c, Node i, Node j, Node k) {
    if (i == j || j == k || k == i) return;
    triangles.push_back({i, j, k});
    cell_of.push_back(soup_.cell_tag(c));
  }
  void add_quad(std::size_t c, Node i, Node j, Node k, Node l) {
    const auto length = [&](Node a, Node b) {
      return kernel::distance(soup_.points[static_cast<std::size_t>(a)],
                              soup_.points[static_cast<std::size_t>(b)]);
    };
    ++quads_;
    if (length(i, k) <= length(j, l)) {
      add(c, i, j, k);
      add(c, i, k, l);
    } else {
      add(c, i, j, l);
      add(c, j, k, l);
    }
  }
  void add_cell(std::size_t c) {
    const auto n = soup_.cells.nodes(c);
    for (const Node v : n)
      if (v < 0 || static_cast<std::size_t>(v) >= soup_.points.size())
        fail(fmt::format("cell {}", soup_.cell_tag(c)), "has a node that does not exist",
             "export the file again");
    const CellType type = soup_.cells.type(c);
    if (type == CellType::triangle && n.size() == 3)
      add(c, n[0], n[1], n[2]);
    else if (type == CellType::quad && n.size() == 4)
      add_quad(c, n[0], n[1], n[2], n[3]);
    else if (type == CellType::pixel && n.size() == 4)
      add_quad(c, n[0], n[1], n[3], n[2]);
    else if (type == CellType::polygon && n.size() == 3)
      add(c, n[0], n[1], n[2]);
    else if (type == CellType::polygon && n.size() == 4)
      add_quad(c, n[0], n[1], n[2], n[3]);
    else if (type == CellType::triangle_strip)
      for (std::size_t i = 0; i + 2 < n.size(); ++i)
        add(c, n[i + i % 2], n[i + 1 - i % 2], n[i + 2]);
    else
      ++left_out_;
  }

  const Soup& soup_;
  std::size_t left_out_ = 0, quads_ = 0;
};

bool is_vector(const Field& f) {
  return f.components == 2 || f.components == 3;
}

std::string vector_names(const std::vector<Field>& fields) {
  std::string names;
  for (const Field& f : fields)
    if (is_vector(f))
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", f.name.substr(0, 60));
  return names;
}

std::string known_vectors(const Soup& soup) {
  const std::string points = vector_names(soup.point_fields),
                    cells = vector_names(soup.cell_fields);
  if (!points.empty()) return "the vectors of points are " + points;
  if (!cells.empty()) return "the vectors of cells are " + cells + "; take them by --cell-to-point";
  return "the file has no vectors";
}

const Field& vector_field(const Soup& soup, const VectorRequest& request) {
  const Field* found = nullptr;
  const auto& fields = request.cell_to_point ? soup.cell_fields : soup.point_fields;
  for (const Field& f : fields) {
    if (request.field.empty() ? !is_vector(f) : f.name != request.field) continue;
    if (found)
      fail("vectors", "there are several", known_vectors(soup) + "; choose one with --vectors");
    found = &f;
  }
  const std::string element =
      request.field.empty() ? "vectors" : fmt::format("array '{}'", request.field);
  if (!found) fail(element, "do not exist", known_vectors(soup));
  if (!is_vector(*found))
    fail(element, fmt::format("has {} components", found->components), known_vectors(soup));
  const std::size_t count = request.cell_to_point ? soup.cells.size() : soup.points.size();
  if (found->size() != static_cast<std::size_t>(found->components) * count)
    fail(element, "has not one vector a point", "export it again");
  return *found;
}

Vec2 vector_at(const Field& f, std::size_t i) {
  const auto number = [&](std::size_t k) {
    return std::visit([k](const auto& x) { return static_cast<double>(x[k]); }, f.numbers);
  };
  const auto n = static_cast<std::size_t>(f.components);
  if (!f.missing.empty() && f.missing[i]) return {std::nan(""), std::nan("")};
  return {number(n * i), number(n * i + 1)};
}

/// Means over the cells around each point.
std::vector<Vec2> means(const Soup& soup, const Field& f) {
  std::vector<Vec2> sum(soup.points.size(), Vec2{0, 0});
  std::vector<double> count(soup.points.size(), 0);
  for (std::size_t c = 0; c < soup.cells.size(); ++c)
    for (const Node v : soup.cells.nodes(c)) {
      const auto i = static_cast<std::size_t>(v);
      const Vec2 x = vector_at(f, c);
      for (std::size_t k = 0; k < 2; ++k) sum[i][k] += x[k];
      ++count[i];
    }
  for (std::size_t i = 0; i < sum.size(); ++i)
    for (double& x : sum[i]) x /= count[i];
  return sum;
}

/// The points that are used, plane and finite, with their vectors.
void take_points(const Soup& soup, const Field& field, bool of_cells, PlanarFieldFile& file,
                 std::vector<Index>& number_of) {
  const std::vector<Vec2> mean = of_cells ? means(soup, field) : std::vector<Vec2>{};
  double height = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (number_of[v] != 0) continue;
    const auto& p = soup.points[v];
    for (const double x : p)
      if (!std::isfinite(x)) fail(soup.point_name(v), "is not finite", "repair it");
    if (file.points.empty()) height = p[2];
    if (p[2] != height)
      fail(soup.point_name(v), "does not lie in the plane of the first", "give a plane mesh");
    number_of[v] = static_cast<Index>(file.points.size());
    file.points.push_back({p[0], p[1]});
    file.vectors.push_back(of_cells ? mean[v] : vector_at(field, v));
    for (const double x : file.vectors.back())
      if (!std::isfinite(x))
        fail(soup.point_name(v), fmt::format("its vector of '{}' is not finite", field.name),
             "repair the field");
  }
  if (file.points.size() < soup.points.size())
    file.warnings.push_back(fmt::format("{} points that no cell uses left out",
                                        soup.points.size() - file.points.size()));
}

}  // namespace

PlanarFieldFile planar_field_of_soup(const Soup& soup, const VectorRequest& request) {
  PlanarFieldFile file;
  Triangles triangles(soup);
  file.warnings = soup.warnings;
  file.warnings.insert(file.warnings.end(), triangles.warnings.begin(), triangles.warnings.end());
  const Field& field = vector_field(soup, request);
  file.field = field.name;
  std::vector<Index> number_of(soup.points.size(), kernel::kNone);
  for (const auto& t : triangles.triangles)
    for (const Node v : t) number_of[static_cast<std::size_t>(v)] = 0;
  take_points(soup, field, request.cell_to_point, file, number_of);
  for (const auto& t : triangles.triangles) {
    auto& to = file.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) to[i] = number_of[static_cast<std::size_t>(t[i])];
  }
  // Seen from below all triangles are clockwise: those of a file that is so are turned, all.
  const auto& [a, b, c] = file.triangles.front();
  if (kernel::orientation(file.points[a], file.points[b], file.points[c]) == kernel::Sign::negative)
    for (auto& t : file.triangles) std::swap(t[1], t[2]);
  file.cell_of = std::move(triangles.cell_of);
  return file;
}

PlanarFieldFile read_planar_field(const std::string& path, const VectorRequest& request) {
  PlanarFieldFile file;
  read_named(path, [&] {
    const std::string end = lower_extension(path);
    const bool grid =
        end == ".vti" || end == ".vtr" || end == ".vts" || (end == ".vtk" && is_legacy_grid(path));
    if (grid) return add_triangles(read_vtk_grid(path, request, file), request.diagonal, file);
    if (end == ".nrrd" || end == ".nhdr")
      return add_triangles(read_vector_nrrd(path, request, file), request.diagonal, file);
    if (end == ".nc" || end == ".nc4" || end == ".cdf") return read_net_cdf(path, request, file);
    if (end == ".json") return add_triangles(read_wind_json(path, file), request.diagonal, file);
    if (end == ".txt" || end == ".vec")
      return add_triangles(read_particle_image_text(path, request, file), request.diagonal, file);
    FieldRequest fields;
    fields.wanted = true;
    fields.name = request.field;
    file = planar_field_of_soup(read_soup(path, fields), request);
  });
  return file;
}

}  // namespace crest::io
