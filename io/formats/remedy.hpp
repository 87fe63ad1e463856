// SPDX-License-Identifier: GPL-3.0-or-later
// What several readers say would help.
#pragma once

namespace crest::io {

inline constexpr const char* kExportMesh = "export the mesh again";
inline constexpr const char* kTruncated = "the file is truncated; export the mesh again";

}  // namespace crest::io
