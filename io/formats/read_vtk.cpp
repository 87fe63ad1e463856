// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's legacy files up to version 5.1, text or binary: polygonal data and unstructured grids.
// Own code: VTK's reader allocates whatever a header announces, follows what it does not check,
// and takes the numbers of a text whose type is float as floats.
#include <fmt/format.h>

#include <array>
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/legacy_fields.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/remedy.hpp"
#include "io/formats/vtk_cells.hpp"

namespace crest::io {
namespace {

class LegacyReader {
 public:
  LegacyReader(std::string_view bytes, const FieldRequest& request)
      : source_(bytes), fields_(source_, request) {}

  Soup read() {
    while (source_.next_section())
      if (!read_geometry() && !fields_.read_section())
        fail(source_.where(), "is an unknown keyword", kExportMesh);
    if (!has_dataset_) fail("header", "has no DATASET", kExportMesh);
    join_cells();
    fields_.finish(soup_);
    return std::move(soup_);
  }

 private:
  bool read_geometry() {
    static const std::map<std::string, PolyKind> lists = {{"vertices", PolyKind::vertices},
                                                          {"lines", PolyKind::lines},
                                                          {"polygons", PolyKind::polygons},
                                                          {"cells", PolyKind::polygons},
                                                          {"triangle_strips", PolyKind::strips}};
    const std::string& section = source_.section();
    const auto list = lists.find(section);
    if (list != lists.end())
      read_cells(list->second);
    else if (section == "dataset")
      read_dataset();
    else if (section == "points")
      read_points();
    else if (section == "cell_types")
      types_ = source_.take_integers({NumberType::i32}, source_.take_count());
    else if (section == "metadata")
      source_.skip_block();
    else
      return false;
    return true;
  }

  void read_dataset() {
    const std::string_view kind = source_.take_word();
    has_dataset_ = is_keyword(kind, "polydata") || is_keyword(kind, "unstructured_grid");
    if (!has_dataset_)
      fail(source_.where(), fmt::format("{} is not read", quoted(kind)),
           "convert it to POLYDATA or UNSTRUCTURED_GRID");
  }

  void read_points() {
    const std::size_t count = source_.take_count();
    const LegacyType type = source_.take_type();
    const Field::Numbers numbers = source_.take(type, source_.product(3, count));
    soup_.points.resize(count);
    std::visit(
        [&](const auto& xs) {
          for (std::size_t i = 0; i < xs.size(); ++i)
            soup_.points[i / 3][i % 3] = static_cast<double>(xs[i]);
        },
        numbers);
  }

  void read_cells(PolyKind kind) {
    Cells& cells = cells_[static_cast<std::size_t>(kind)];
    cells = {};
    const std::size_t count = source_.take_count(), size = source_.take_count();
    if (source_.version() >= 5) return read_offsets(kind, count, size, cells);
    // Each cell is a number of nodes and these.
    const auto list = source_.take_integers({NumberType::i32}, size);
    std::size_t at = 0;
    for (std::size_t c = 0; c < count; ++c) {
      const std::size_t room = list.size() - at;
      if (room == 0 || list[at] < 0 || static_cast<std::size_t>(list[at]) > room - 1)
        fail(source_.section(), fmt::format("cell {} of it does not fit its size {}", c, size),
             kExportMesh);
      const auto nodes = static_cast<std::size_t>(list[at]);
      cells.add(poly_type(kind, nodes), {list.data() + at + 1, nodes});
      at += nodes + 1;
    }
  }

  void read_offsets(PolyKind kind, std::size_t offsets, std::size_t size, Cells& cells) {
    const auto take_array = [&](std::string_view name, std::size_t count) {
      source_.require_more();
      if (!is_keyword(source_.take_word(), name))
        fail(source_.where(), fmt::format("lacks '{}'", name), kExportMesh);
      const LegacyType type = source_.take_type();
      return source_.take_integers(type, count);
    };
    const auto begins = take_array("offsets", offsets), nodes = take_array("connectivity", size);
    const auto type_of = [kind](std::size_t, std::size_t n) { return poly_type(kind, n); };
    add_cells(begins, nodes, source_.section(), type_of, cells);
  }

  /// In VTK's order; those of a grid have types of their own.
  void join_cells() {
    const bool is_grid = !types_.empty();
    const Cells& grid = cells_[static_cast<std::size_t>(PolyKind::polygons)];
    if (is_grid && types_.size() != grid.size())
      fail("cells", "have not one type each", kExportMesh);
    for (const Cells& cells : cells_) {
      for (std::size_t c = 0; c < cells.size(); ++c) {
        CellType type = cells.type(c);
        if (is_grid && &cells == &grid) {
          if (types_[c] < 0 || types_[c] > 255)
            fail(fmt::format("cell {}", c), fmt::format("has the type {}", types_[c]), kExportMesh);
          type = static_cast<CellType>(types_[c]);
        }
        soup_.cells.add(type, cells.nodes(c));
      }
    }
  }

  LegacySource source_;
  LegacyFields fields_;
  bool has_dataset_ = false;
  std::array<Cells, 4> cells_;  ///< by PolyKind
  std::vector<std::int64_t> types_;
  Soup soup_;
};

}  // namespace

Soup read_vtk(std::string_view bytes, const FieldRequest& request) {
  return LegacyReader(bytes, request).read();
}

}  // namespace crest::io
