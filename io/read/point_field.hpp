// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers that a mesh file gives its vertices under a name.
#include <string>
#include <vector>

namespace crest::io {

/// The scalar point field `name` of a .vtp file, one number a vertex of the mesh that read_mesh
/// makes of it, as doubles without loss. Requires: a file that read_mesh accepts. Throws:
/// kernel::InputError, one line, for another format, damage, or a field that is not there,
///   not scalar or not exact as doubles: the message names the fields there are.
std::vector<double> read_point_field(const std::string& path, const std::string& name);

}  // namespace crest::io
