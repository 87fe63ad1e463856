// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Normals that a mesh file gives its vertices.
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::io {

/// The normals of a .ply (nx, ny, nz; text or binary) or .vtp file (the active normals or a point
/// array "Normals"), of the length the file gives, one a vertex of the mesh that read_mesh makes of
/// it.
/// Requires: a file that read_mesh accepts.
/// Throws: kernel::InputError, one line, for another format, a file without normals, or damage.
std::vector<kernel::Vec3> read_normals(const std::string& path);

}  // namespace crest::io
