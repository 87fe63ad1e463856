// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK's parallel files (.pvtp .pvtu .pvti): a text that names the pieces, each a file of its own.
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace crest::io {

/// Of nodes, the first and the last along x, y, z.
using Extent = std::array<int, 6>;

struct ParallelIndex {
  struct Piece {
    std::string source;  ///< relative to the index
    Extent extent{};     ///< of PImageData
  };
  std::vector<Piece> pieces;  ///< at least one, each source once
  Extent whole{};             ///< of PImageData
};

/// `type`: PPolyData, PUnstructuredGrid or PImageData; `extension` is that of its pieces. Throws
/// kernel::InputError.
ParallelIndex parallel_index(std::string_view bytes, const char* type,
                             const std::string& extension);

}  // namespace crest::io
