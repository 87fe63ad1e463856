// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Large texts read in parts side by side, where every line stands for itself. Each of these readers
// gives what the reader of the format gives, or nothing where a line is another than it knows: then
// that reader, which is one after the other, reads or says what is wrong.
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "io/formats/soup.hpp"

namespace crest::io {

/// Whether there is more than one thread to read parts with: one is faster without them.
bool reads_parts();

/// A piece of a text from a line's start up to the next piece.
struct TextPart {
  std::size_t begin, end;
};

/// Bytes of a part.
inline constexpr std::size_t kTextPart = std::size_t{1} << 20;

/// The text from `begin` on, cut behind line feeds about every `size` bytes.
std::vector<TextPart> text_parts(std::string_view text, std::size_t begin,
                                 std::size_t size = kTextPart);

/// A vertex a line, then a triangle a line.
struct TriangleRows {
  std::size_t begin = 0;  ///< of the first vertex' line
  std::size_t vertices = 0, faces = 0;
  std::optional<std::size_t> behind_vertex, behind_face;  ///< other words on its line; else any
  char comment = '\0';
};

/// Reads lines "x y z" and "3 a b c" into a soup without points and cells. False, and nothing read,
/// unless there are as many lines, none of them blank, with finite numbers and indices of vertices.
bool read_triangle_rows(std::string_view text, const TriangleRows& rows, Soup& soup,
                        std::size_t part_size = kTextPart);

/// Reads the vertices and faces of an OBJ file that has only triangles with indices counted from
/// the file's start, and no line that is continued. False, and nothing read, otherwise.
bool read_obj_triangles(std::string_view text, Soup& soup, std::size_t part_size = kTextPart);

}  // namespace crest::io
