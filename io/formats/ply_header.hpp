// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a PLY file says about itself.
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/binary.hpp"

namespace crest::io {

struct PlyProperty {
  std::string name;
  bool list = false;
  NumberType length{}, value{};  ///< of a list; of its numbers or the one number
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  enum class Kind { vertices, faces, strips, other };
  Kind kind() const;
  bool vertices() const { return kind() == Kind::vertices; }
  bool faces() const { return kind() == Kind::faces; }
  bool strips() const { return kind() == Kind::strips; }
  /// For messages.
  const char* singular() const {
    return vertices() ? "vertex" : faces() ? "face" : strips() ? "strip" : name.c_str();
  }
  const PlyProperty* find(std::string_view property) const;
  /// The corners of faces or strips, or null.
  const PlyProperty* corners() const;
  /// Bytes of one in a binary file, at least: lists may be empty.
  std::size_t least_size() const;
};

struct PlyHeader {
  bool binary = false, big_endian = false;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes up to the data
};

/// Throws: kernel::InputError for a header that is wrong, has no faces with corners (unless points
/// will do) or announces more than the bytes behind it may hold.
PlyHeader read_ply_header(std::string_view bytes, bool points_will_do);

}  // namespace crest::io
