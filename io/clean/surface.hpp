// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangles on their way from a soup to a mesh: each step of the cleaning changes them in place and
// keeps where they come from.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/formats/soup.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::io {

/// V vertices, F faces. Positions may coincide and faces overlap: cleaning is what ends that.
struct Surface {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Index> point_of;  ///< V: the soup's point it is
  std::vector<kernel::Triangle> faces;
  std::vector<kernel::Index> cell_of;  ///< F: the soup's cell it is of
  /// F or none: the soup's points in the middle of the sides (0 1), (1 2), (2 0), or kNone thrice.
  std::vector<std::array<kernel::Index, 3>> midside = {};
  /// F or none: where the corners stand among the cell's (corners_of), or kNone thrice. Only of
  /// polygons that meet a vertex more than once, where the vertices do not tell.
  std::vector<std::array<kernel::Index, 3>> places = {};
  std::vector<kernel::Index> between =
      {};  ///< the soup's points of curved faces beside the corners

  kernel::Index vertex_count() const { return static_cast<kernel::Index>(points.size()); }
  kernel::Index face_count() const { return static_cast<kernel::Index>(faces.size()); }
};

/// What the file calls them, for messages.
inline std::string face_name(const Soup& soup, const Surface& surface, kernel::Index f) {
  return "face " + std::to_string(soup.cell_tag(surface.cell_of[f]));
}
inline std::string vertex_name(const Soup& soup, const Surface& surface, kernel::Index v) {
  return soup.point_name(surface.point_of[v]);
}

/// What the file calls a surface's vertices and faces. The triangles of a polygon have one number,
/// as have the vertices that one was split into; welded and collapsed ones have the first's.
struct FileNumbers {
  /// V and F, or none of either: then they are numbered from 0 on.
  std::vector<std::int64_t> vertices, faces;
  std::int64_t vertex(kernel::Index v) const { return vertices.empty() ? v : vertices[v]; }
  std::int64_t face(kernel::Index f) const { return faces.empty() ? f : faces[f]; }
};

inline FileNumbers file_numbers(const Soup& soup, const Surface& surface) {
  FileNumbers numbers;
  numbers.vertices.reserve(surface.point_of.size());
  numbers.faces.reserve(surface.cell_of.size());
  for (const kernel::Index point : surface.point_of)
    numbers.vertices.push_back(soup.point_tag(point));
  for (const kernel::Index cell : surface.cell_of) numbers.faces.push_back(soup.cell_tag(cell));
  return numbers;
}

}  // namespace crest::io
