// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The readers of the formats. Each throws kernel::InputError without the file's name.
#include <string>
#include <string_view>

#include "io/formats/soup.hpp"

namespace crest::io {

/// The point field to read: none, the one named, or (empty name) any.
struct FieldRequest {
  bool wanted = false;
  std::string name = {};
};

Soup read_off(std::string bytes, const FieldRequest& request);
Soup read_obj(std::string bytes, const FieldRequest& request);
Soup read_ply(std::string bytes, const FieldRequest& request);  ///< fields: normals
Soup read_stl(std::string bytes, const FieldRequest& request);
Soup read_vtp(std::string bytes, const FieldRequest& request);
Soup read_vtu(std::string bytes, const FieldRequest& request);
Soup read_msh(std::string bytes, const FieldRequest& request);

using SoupReader = Soup (*)(std::string, const FieldRequest&);

/// The reader of surfaces of an extension (lower case); fails for an unknown one, saying `others`
/// are known too.
SoupReader soup_reader(const std::string& extension, const std::string& others = "");

/// OFF with checks like those below, which have to read every number anyway; CGAL's reader takes
/// ten times as long as they do. Numbers are rounded as an istream does, bit for bit.
Soup parse_off(std::string_view text);

/// The checks before CGAL or VTK reads: they name the line and element that it would refuse, ignore
/// or crash on, and blank out what it cannot skip.
void check_obj(std::string& text);
void check_ply(const std::string& bytes);
void check_stl(std::string& bytes);
void check_vtp(const std::string& bytes);  ///< and VTU

/// The normals (nx, ny, nz) that a PLY file gives its vertices; no field if it gives none.
std::vector<Field> ply_normals(const std::string& bytes);

}  // namespace crest::io
