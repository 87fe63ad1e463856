// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What cleaning is asked for, and what it did: the counts of the report's `cleanup`.
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/formats/soup.hpp"

namespace crest::io {

/// What changes a surface beyond what every file gets.
struct CleanOptions {
  std::optional<double> weld = {};  ///< vertices within this distance become one; 0: equal ones
  bool split = false;    ///< cut at edges of three or more faces, and one-sided parts open
  bool outward = false;  ///< turn closed parts whose volume is negative
};

/// Numbers of what was left out, changed or only seen. Faces are counted as triangles, but for
/// `polygons`.
struct CleanUp {
  std::map<CellType, std::size_t> other_cells = {};  ///< not of dimension 2, left out
  std::size_t polygons = 0;          ///< faces of the file that became several triangles
  std::size_t curved_faces = 0;      ///< of higher order, taken by their corners
  std::size_t repeated_corners = 0;  ///< faces left out
  std::size_t duplicate_faces = 0;   ///< left out
  std::size_t unused_vertices = 0;   ///< left out
  std::size_t welded_vertices = 0;   ///< joined to another
  std::size_t split_vertices = 0;    ///< in which several fans met
  std::size_t cut_edges = 0;         ///< of three or more faces, or where a part is one-sided
  std::size_t collapsed_edges = 0;   ///< of zero length, or of faces of area zero
  std::size_t flipped_edges = 0;     ///< replaced by the other diagonal of two faces, one of area 0
  std::size_t trimmed_faces = 0;     ///< of area zero at the boundary, left out
  std::size_t turned_faces = 0;      ///< oriented against the majority of their part
  std::size_t turned_parts = 0;      ///< closed ones of negative volume
  std::size_t coincident_vertices = 0;  ///< seen: with the place of another one
  std::size_t inside_out_parts = 0;     ///< seen: closed, of negative volume
};

/// One line for every count that is not zero, what to do about it where there is something.
std::vector<std::string> words(const CleanUp& done);

}  // namespace crest::io
