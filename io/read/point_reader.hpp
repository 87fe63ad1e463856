// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points with normals, from files.
#include <string>
#include <string_view>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::io {

struct PointFile {
  std::vector<kernel::Vec3> points, normals;  ///< as the file has them: of any length but zero
  std::vector<std::string> warnings;
};

/// Whether the file's name is that of points alone; meshes with normals are read as points, too.
bool is_point_name(const std::string& path);

/// Reads .xyz and .pwn (six numbers a line: x y z nx ny nz; '#' starts a comment) and the normals
/// of .ply .obj .off .vtp .vtk .vtu .stl, where faces may be missing. Points whose normal is zero
/// are left out with a warning; equal points are kept. Guarantees: all numbers finite, no normal
/// zero. Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line: no normals, none
/// but zero.
PointFile read_points(const std::string& path);

/// The same for a file that is in memory: `name` gives the format and stands in messages.
PointFile read_points_bytes(const std::string& name, std::string_view bytes);

}  // namespace crest::io
