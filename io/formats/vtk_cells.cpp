// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk_cells.hpp"

#include <fmt/format.h>

#include "io/formats/files.hpp"

namespace crest::io {

CellType poly_type(PolyKind kind, std::size_t nodes) {
  switch (kind) {
    case PolyKind::vertices:
      return nodes == 1 ? CellType::vertex : CellType::poly_vertex;
    case PolyKind::lines:
      return nodes == 2 ? CellType::line : CellType::poly_line;
    case PolyKind::polygons:
      break;
    case PolyKind::strips:
      return CellType::triangle_strip;
  }
  return face_type(nodes);
}

void add_cells(std::span<const std::int64_t> begins, std::span<const std::int64_t> nodes,
               const std::string& element,
               const std::function<CellType(std::size_t c, std::size_t nodes)>& type_of,
               Cells& cells) {
  const auto size = static_cast<std::int64_t>(nodes.size());
  const std::size_t count = begins.empty() ? 0 : begins.size() - 1;
  cells.reserve(cells.size() + count, cells.node_count() + nodes.size());
  for (std::size_t c = 0; c < count; ++c) {
    const std::int64_t begin = begins[c], end = begins[c + 1];
    if (begin < 0 || end < begin || end > size)
      fail(fmt::format("{} {}", element, c), "its offsets are wrong", "export the mesh again");
    const auto length = static_cast<std::size_t>(end - begin);
    cells.add(type_of(c, length), nodes.subspan(static_cast<std::size_t>(begin), length));
  }
}

}  // namespace crest::io
