// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A stream to a mesh, by docs/cmc-format.md alone.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace crest::certify {

struct DecodedMesh {
  std::uint32_t vertices = 0, components = 0, loops = 0, handles = 0;  ///< of the header
  int method = 0;          ///< 0 valence, 1 fan, 2 zigzag, 3 static
  int positions_mode = 0;  ///< 0 none, 1 exact, 2 within a tolerance
  bool ordered = false;
  std::size_t connectivity_bytes = 0;
  bool has_attributes = false;                          ///< a section that is not decoded
  std::vector<std::array<std::uint32_t, 3>> faces;      ///< in the final numbers and order
  std::vector<std::array<std::uint64_t, 3>> positions;  ///< V binary64 patterns, or none
};

/// The parts of a header that its sections need.
struct StreamCounts {
  std::uint32_t vertices = 0, components = 0, loops = 0, handles = 0;
};
using FaceList = std::vector<std::array<std::uint32_t, 3>>;

/// Requires: the mesh sought has `vertices` and `faces`; nothing larger is made.
/// Throws: Reject.
DecodedMesh decode_stream(std::span<const std::uint8_t> stream, std::size_t vertices,
                          std::size_t faces);

/// Sections 5, and 6 and 7: faces in the decoder's numbers. Throws: Reject.
FaceList decode_valences(std::span<const std::uint8_t> section, const StreamCounts& counts,
                         std::size_t faces);
FaceList decode_strips(std::span<const std::uint8_t> section, const StreamCounts& counts,
                       int method, std::size_t faces);
/// Section 8: V patterns. Requires: an oriented manifold. Throws: Reject.
std::vector<std::array<std::uint64_t, 3>> decode_positions(std::span<const std::uint8_t> section,
                                                           const FaceList& faces,
                                                           std::size_t vertices, int mode);

}  // namespace crest::certify
