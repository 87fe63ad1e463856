// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Geomview's binary OFF.
#include <string_view>

#include "io/formats/soup.hpp"

namespace crest::io {

/// What a vertex of OFF has besides its place, as its keyword says.
struct OffVertex {
  bool normals = false;
  std::size_t numbers_behind = 0;  ///< after place and normal: colour, texture
};

/// Of the bytes behind the line "[ST][C][N]OFF BINARY": integers of 32 bits and floats, big endian;
/// a face is a number of corners, these, and a number of colour components with these.
/// `normals`: take those that the vertices have.
Soup read_binary_off(std::string_view bytes, OffVertex vertex, bool normals);

}  // namespace crest::io
