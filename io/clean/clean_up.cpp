// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/clean_up.hpp"

#include <fmt/format.h>

namespace crest::io {
namespace {

/// "1 face", "2 faces".
std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string counted_cells(CellType type, std::size_t count) {
  switch (type) {
    case CellType::tetrahedron:
    case CellType::quadratic_tetrahedron:
      return counted(count, "tetrahedron", "tetrahedra");
    case CellType::hexahedron:
    case CellType::voxel:
    case CellType::quadratic_hexahedron:
      return counted(count, "hexahedron", "hexahedra");
    case CellType::wedge:
    case CellType::quadratic_wedge:
      return counted(count, "prism", "prisms");
    case CellType::pyramid:
    case CellType::quadratic_pyramid:
      return counted(count, "pyramid", "pyramids");
    default:
      break;
  }
  switch (dimension_of(type)) {
    case 0:
      return counted(count, "point", "points");
    case 1:
      return counted(count, "line", "lines");
    default:
      return counted(count, "solid", "solids");
  }
}

std::string other_cells(const CleanUp& done) {
  std::string list;
  for (const auto& [type, count] : done.other_cells)
    list += (list.empty() ? "left out " : ", ") + counted_cells(type, count);
  return list;
}

}  // namespace

std::vector<std::string> words(const CleanUp& done) {
  std::vector<std::string> lines;
  const auto say = [&](std::size_t count, const char* form, const char* one, const char* many) {
    if (count > 0) lines.push_back(fmt::format(fmt::runtime(form), counted(count, one, many)));
  };
  if (!done.other_cells.empty()) lines.push_back(other_cells(done));
  say(done.polygons, "split {} into triangles", "polygon", "polygons");
  say(done.curved_faces, "took {} by the corners alone", "curved face", "curved faces");
  say(done.repeated_corners, "left out {} with repeated corners", "face", "faces");
  say(done.duplicate_faces, "left out {} with the vertices of another", "face", "faces");
  say(done.unused_vertices, "left out {} that no face uses", "vertex", "vertices");
  say(done.welded_vertices, "welded {} to others", "vertex", "vertices");
  say(done.split_vertices, "split {} where several fans of faces meet", "vertex", "vertices");
  say(done.cut_edges, "cut the surface at {}", "edge", "edges");
  say(done.collapsed_edges, "collapsed {} of length zero or of a face of area zero", "edge",
      "edges");
  say(done.flipped_edges, "flipped {} of a face of area zero", "edge", "edges");
  say(done.trimmed_faces, "left out {} of area zero at the boundary", "face", "faces");
  say(done.turned_faces, "flipped {} oriented against the majority of their component", "face",
      "faces");
  say(done.turned_parts, "turned {} with negative volume", "closed component", "closed components");
  say(done.coincident_vertices,
      "{} at the place of another one, faces that only meet there are not joined; --weld 0 makes "
      "them one",
      "vertex stands", "vertices stand");
  say(done.inside_out_parts,
      "{} negative volume, as if seen from inside: signs and colours are then exchanged; --outward "
      "turns such components",
      "closed component has", "closed components have");
  return lines;
}

}  // namespace crest::io
