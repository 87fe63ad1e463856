// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cells as VTK's formats store them.
#include <functional>
#include <span>
#include <string>

#include "io/formats/soup.hpp"

namespace crest::io {

/// The four lists of polygonal data, in the order in which VTK numbers their cells.
enum class PolyKind { vertices, lines, polygons, strips };

CellType poly_type(PolyKind kind, std::size_t nodes);

/// Adds the cells c of nodes begins[c] .. begins[c + 1] - 1; `type_of` cell c with so many nodes.
/// Throws, naming `element` c, when the offsets are wrong.
void add_cells(std::span<const std::int64_t> begins, std::span<const std::int64_t> nodes,
               const std::string& element,
               const std::function<CellType(std::size_t c, std::size_t nodes)>& type_of,
               Cells& cells);

}  // namespace crest::io
