// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The readers of the formats: bytes to a soup. Each throws kernel::InputError without the file's
// name, allocates nothing on the strength of a count that the bytes are too few for, and rounds
// numbers in texts correctly to doubles, whatever type a header gives them.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/formats/soup.hpp"

namespace crest::io {

/// The fields to read, of points and of cells alike. The others of a file may be listed without
/// their numbers, so that a message can name them.
struct FieldRequest {
  bool wanted = false;
  std::string name = {};                  ///< of the field; empty: all fields
  bool normals = false;                   ///< those of the points, whatever their name
  std::optional<std::int64_t> step = {};  ///< of time, as the file numbers it; else its last
  bool corners = false;  ///< numbers at corners of faces as they are, not as the vertices' normals
  bool points = false;  ///< will do without faces; in OBJ the n-th normal is the n-th vertex's then
  bool asks_for(const std::string& field) const {
    return wanted && (name.empty() || name == field);
  }
};

Soup read_off(std::string_view bytes, const FieldRequest& request);  ///< fields: normals
Soup read_obj(std::string_view bytes, const FieldRequest& request);  ///< normals; corners' textures
Soup read_ply(std::string_view bytes, const FieldRequest& request);
Soup read_stl(std::string_view bytes, const FieldRequest& request);  ///< no fields
Soup read_vtp(std::string_view bytes, const FieldRequest& request);
Soup read_vtu(std::string_view bytes, const FieldRequest& request);
Soup read_vtk(std::string_view bytes, const FieldRequest& request);  ///< legacy
Soup read_msh(std::string_view bytes, const FieldRequest& request);  ///< the one with time steps

using SoupReader = std::function<Soup(std::string_view, const FieldRequest&)>;

/// The reader of an extension (lower case, with its dot), which refuses a time step where the
/// format has none; fails for an unknown extension.
SoupReader soup_reader(const std::string& extension);

/// Of a file, whose extension is looked at before it is loaded; of .pvtp and .pvtu the pieces that
/// they name (join_soups.hpp). What holds another format than its
/// name says, or is compressed, is refused with that.
Soup read_soup(const std::string& path, const FieldRequest& request);
/// Of its bytes. Throws as for a file, and where its pieces are in other files.
Soup read_soup(const std::string& name, std::string_view bytes, const FieldRequest& request);

}  // namespace crest::io
