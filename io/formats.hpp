// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the writers of several formats share.
#include <string>

class vtkPolyData;

namespace crest::io {

/// A .vtp file's bytes: appended raw binary, not compressed: the bytes depend on the data alone.
/// Throws: std::runtime_error when VTK fails.
std::string vtp_bytes(vtkPolyData& data);

/// The extension in lower case, with its dot.
std::string lower_extension(const std::string& path);

}  // namespace crest::io
