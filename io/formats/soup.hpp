// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points, cells of any dimension and fields as they stand in a file: what every reader produces.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/attribute.hpp"

namespace crest::io {

/// VTK's numbers, nodes in VTK's order. A file may have others: they are kept, too.
enum class CellType : std::uint8_t {
  empty = 0,
  vertex = 1,
  poly_vertex = 2,
  line = 3,
  poly_line = 4,
  triangle = 5,
  triangle_strip = 6,
  polygon = 7,
  pixel = 8,
  quad = 9,
  tetrahedron = 10,
  voxel = 11,
  hexahedron = 12,
  wedge = 13,
  pyramid = 14,
  quadratic_edge = 21,
  quadratic_triangle = 22,
  quadratic_quad = 23,
  quadratic_tetrahedron = 24,
  quadratic_hexahedron = 25,
  quadratic_wedge = 26,
  quadratic_pyramid = 27,
  biquadratic_quad = 28,
  triquadratic_hexahedron = 29,
  quadratic_linear_quad = 30,
  biquadratic_wedge = 32,
  biquadratic_triangle = 34,
  quadratic_polygon = 36,
  lagrange_curve = 68,
  lagrange_triangle = 69,
  lagrange_quad = 70,
  lagrange_tetrahedron = 71,
  lagrange_hexahedron = 72,
  lagrange_wedge = 73,
  lagrange_pyramid = 74,
  bezier_triangle = 76,
  bezier_quad = 77
};

/// What a list of so many corners of a face is: a triangle, a quad or a polygon, which may have
/// fewer than 3.
constexpr CellType face_type(std::size_t corners) {
  return corners == 3 ? CellType::triangle : corners == 4 ? CellType::quad : CellType::polygon;
}

/// 0 to 3 for VTK's types, -1 for another number.
int dimension_of(CellType type);

/// Cells in the file's order. Nodes are positions of points; none of them is checked.
class Cells {
 public:
  using Node = std::int64_t;
  void reserve(std::size_t cells, std::size_t nodes);
  void add(CellType type, std::span<const Node> nodes) {
    types_.push_back(type);
    for (const Node v : nodes) nodes_.push_back(v);  // cells are small: faster than insert
    begin_.push_back(nodes_.size());
  }
  std::size_t size() const { return types_.size(); }
  bool empty() const { return types_.empty(); }
  std::size_t node_count() const { return nodes_.size(); }
  CellType type(std::size_t c) const { return types_[c]; }
  std::span<const Node> nodes(std::size_t c) const {
    return {nodes_.data() + begin_[c], nodes_.data() + begin_[c + 1]};
  }

 private:
  std::vector<CellType> types_;
  std::vector<std::size_t> begin_{0};  ///< in nodes_, one more at the end
  std::vector<Node> nodes_;
};

/// Numbers of points, cells or corners, those of one next to each other: a scalar, a vector, a
/// tensor.
struct Field {
  /// Reals and integers as the file has them: neither rounds the other.
  using Numbers =
      std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint64_t>>;

  std::string name;
  int components = 1;           ///< of each point or cell; 0: these are no numbers
  Numbers numbers{};            ///< empty: not asked for
  bool normals = false;         ///< the file says that they are the points' normals
  std::vector<bool> missing{};  ///< points or cells without a value (of 0); empty: none
  std::optional<kernel::NumberType> type{};  ///< that the file says the numbers have
  std::size_t size() const;                  ///< of numbers
};

/// What a file holds, nothing left out or mended: faces with repeated corners, equal points (those
/// of STL alone are merged), points that nothing uses. Coordinates and values may be NaN or
/// infinite. Thin cells and solids stand among the others.
struct Soup {
  std::vector<kernel::Vec3> points;
  Cells cells;
  std::vector<Field> point_fields, cell_fields;
  /// At the nodes of cells, in their order, of the first cells or all: only where they were asked
  /// for.
  std::vector<Field> corner_fields;
  /// What the file calls them, for messages; empty: by position.
  std::vector<std::int64_t> point_tags, cell_tags;
  /// Lines of a text with points that are not finite: (point, line), ascending.
  std::vector<std::pair<std::size_t, std::size_t>> lines_not_finite;
  /// What is odd about the file and does no harm, a line each.
  std::vector<std::string> warnings;

  /// "vertex 7 (line 12)", by its tag; the line where it is known.
  std::string point_name(std::size_t v) const;
  std::int64_t point_tag(std::size_t v) const {
    return point_tags.empty() ? static_cast<std::int64_t>(v) : point_tags[v];
  }
  std::int64_t cell_tag(std::size_t c) const {
    return cell_tags.empty() ? static_cast<std::int64_t>(c) : cell_tags[c];
  }
};

}  // namespace crest::io
