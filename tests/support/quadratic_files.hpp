// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces of quadratic triangles, and the texts of files that hold them.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/quadratic_mesh.hpp"

namespace crest::tests {

using kernel::Index;
using kernel::Vec3;

/// Cells: three corners, then the nodes in the middle of the sides (0 1), (1 2), (2 0); or corners
/// alone (the last three kNone).
struct QuadraticGrid {
  std::vector<Vec3> nodes;
  std::vector<std::array<Index, 6>> cells;
  std::vector<double> values;  ///< of the nodes
};

using PlaceFunction = std::function<double(const Vec3&)>;

/// Adds mid-side nodes to triangles, and the function's values.
inline QuadraticGrid quadratic_grid(std::vector<Vec3> points,
                                    const std::vector<kernel::Triangle>& faces,
                                    const PlaceFunction& function) {
  QuadraticGrid grid{std::move(points), {}, {}};
  std::map<std::pair<Index, Index>, Index> middle;
  for (const kernel::Triangle& f : faces) {
    std::array<Index, 6> cell = {f[0], f[1], f[2], 0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = f[k], b = f[(k + 1) % 3];
      const auto [at, added] =
          middle.try_emplace(std::minmax(a, b), static_cast<Index>(grid.nodes.size()));
      if (added) {
        const Vec3 p = grid.nodes[a], q = grid.nodes[b];
        grid.nodes.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
      }
      cell[3 + k] = at->second;
    }
    grid.cells.push_back(cell);
  }
  for (const Vec3& p : grid.nodes) grid.values.push_back(function(p));
  return grid;
}

/// (n + 1)^2 vertices over [-1, 1]^2.
inline QuadraticGrid square_grid(Index n, const PlaceFunction& function) {
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) points.push_back({2.0 * i / n - 1, 2.0 * j / n - 1, 0});
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
    }
  }
  return quadratic_grid(std::move(points), faces, function);
}

/// A torus around the z-axis, radii 2 and 1, n times m vertices.
inline QuadraticGrid torus_grid(Index n, Index m, const PlaceFunction& function) {
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  constexpr double turn = 6.283185307179586;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < m; ++j) {
      const double u = turn * i / n, v = turn * j / m, r = 2 + std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const Index a = i * m + j, b = (i + 1) % n * m + j;
      const Index c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  return quadratic_grid(std::move(points), faces, function);
}

/// A strip of n quadrilaterals joined with a half turn.
inline QuadraticGrid moebius_grid(Index n, const PlaceFunction& function) {
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  constexpr double turn = 6.283185307179586;
  for (Index i = 0; i < n; ++i) {
    for (const double side : {-0.4, 0.4}) {
      const double u = turn * i / n, r = 1 + side * std::cos(u / 2);
      points.push_back({r * std::cos(u), r * std::sin(u), side * std::sin(u / 2)});
    }
    const bool last = i + 1 == n;
    const Index a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  return quadratic_grid(std::move(points), faces, function);
}

inline kernel::QuadraticMesh mesh_of(const QuadraticGrid& grid) {
  std::vector<Index> number(grid.nodes.size(), kernel::kNone);
  for (const auto& cell : grid.cells)
    for (std::size_t k = 0; k < 3; ++k) number[cell[k]] = 0;
  std::vector<Vec3> points;
  std::vector<double> values;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] != 0) continue;
    number[v] = static_cast<Index>(points.size());
    points.push_back(grid.nodes[v]);
    values.push_back(grid.values[v]);
  }
  std::vector<kernel::Triangle> faces;
  std::vector<std::array<double, 3>> midside;
  for (const auto& c : grid.cells) {
    faces.push_back({number[c[0]], number[c[1]], number[c[2]]});
    midside.push_back({grid.values[c[3]], grid.values[c[4]], grid.values[c[5]]});
  }
  return {std::move(points), std::move(faces), std::move(values), midside};
}

inline std::size_t cell_size(const std::array<Index, 6>& cell) {
  return cell[3] == kernel::kNone ? 3 : 6;
}

inline std::string vtu_text(const QuadraticGrid& grid, const std::string& field = "T") {
  std::ostringstream text;
  text.precision(17);
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
          "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
       << "<Piece NumberOfPoints=\"" << grid.nodes.size() << "\" NumberOfCells=\""
       << grid.cells.size() << "\">\n<PointData>\n<DataArray type=\"Float64\" Name=\"" << field
       << "\" format=\"ascii\">\n";
  for (const double x : grid.values) text << x << '\n';
  text << "</DataArray>\n</PointData>\n<Points>\n<DataArray type=\"Float64\" "
          "NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Vec3& p : grid.nodes) text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  text << "</DataArray>\n</Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" "
          "format=\"ascii\">\n";
  for (const auto& cell : grid.cells) {
    for (std::size_t k = 0; k < cell_size(cell); ++k) text << cell[k] << ' ';
    text << '\n';
  }
  text << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t offset = 0;
  for (const auto& cell : grid.cells) text << (offset += cell_size(cell)) << '\n';
  text << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (const auto& cell : grid.cells) text << (cell_size(cell) == 6 ? 22 : 5) << '\n';
  text << "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text.str();
}

/// Gmsh text, version 2 (2.2) or 4 (4.1). Tags are not positions: 10 + 3 times these.
inline std::string msh_text(const QuadraticGrid& grid, int version,
                            const std::string& field = "T") {
  const auto tag = [](std::size_t i) { return 10 + 3 * i; };
  std::ostringstream text;
  text.precision(17);
  const std::size_t nodes = grid.nodes.size(), cells = grid.cells.size();
  text << "$MeshFormat\n" << (version == 2 ? "2.2" : "4.1") << " 0 8\n$EndMeshFormat\n$Nodes\n";
  if (version == 2) {
    text << nodes << '\n';
    for (std::size_t i = 0; i < nodes; ++i) {
      const Vec3& p = grid.nodes[i];
      text << tag(i) << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
  } else {
    text << "1 " << nodes << " 10 " << tag(nodes) << "\n2 1 0 " << nodes << '\n';
    for (std::size_t i = 0; i < nodes; ++i) text << tag(i) << '\n';
    for (const Vec3& p : grid.nodes) text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  text << "$EndNodes\n$Elements\n";
  text << (version == 2 ? std::to_string(cells + 1) + "\n1 15 2 0 1 10\n"
                        : std::to_string(cells + 1) + " " + std::to_string(cells + 1) +
                              " 1 9\n0 1 15 1\n1 10\n");
  for (std::size_t c = 0; c < cells; ++c) {
    const std::size_t size = cell_size(grid.cells[c]);
    const int type = size == 6 ? 9 : 2;
    if (version == 2)
      text << tag(c) << ' ' << type << " 2 1 1";
    else
      text << "2 1 " << type << " 1\n" << tag(c);
    for (std::size_t k = 0; k < size; ++k) text << ' ' << tag(grid.cells[c][k]);
    text << '\n';
  }
  text << "$EndElements\n$NodeData\n1\n\"" << field << "\"\n1\n0\n3\n0\n1\n" << nodes << '\n';
  for (std::size_t i = 0; i < nodes; ++i) text << tag(i) << ' ' << grid.values[i] << '\n';
  text << "$EndNodeData\n";
  return text.str();
}

}  // namespace crest::tests
