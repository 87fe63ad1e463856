// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/soup.hpp"

namespace crest::io {

int dimension_of(CellType type) {
  switch (type) {
    case CellType::empty:
    case CellType::vertex:
    case CellType::poly_vertex:
      return 0;
    case CellType::line:
    case CellType::poly_line:
    case CellType::quadratic_edge:
      return 1;
    case CellType::triangle:
    case CellType::triangle_strip:
    case CellType::polygon:
    case CellType::pixel:
    case CellType::quad:
    case CellType::quadratic_triangle:
      return 2;
    case CellType::tetrahedron:
    case CellType::voxel:
    case CellType::hexahedron:
    case CellType::wedge:
    case CellType::pyramid:
    case CellType::quadratic_tetrahedron:
      return 3;
  }
  return -1;
}

void Cells::reserve(std::size_t cells, std::size_t nodes) {
  types_.reserve(cells);
  begin_.reserve(cells + 1);
  nodes_.reserve(nodes);
}

std::size_t Field::size() const {
  return std::visit([](const auto& values) { return values.size(); }, numbers);
}

}  // namespace crest::io
