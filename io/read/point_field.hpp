// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers that a mesh file gives its vertices under a name.
#include <string>
#include <vector>

namespace crest::io {

/// The point array `name` of a .vtp file, one number a point of the file in its order, as doubles.
/// Requires: a file that read_mesh accepts.
/// Throws: kernel::InputError, one line, for another format, damage, or an array that is not there
///   or has not one number a point: the message names the arrays that have.
std::vector<double> read_point_field(const std::string& path, const std::string& name);

}  // namespace crest::io
