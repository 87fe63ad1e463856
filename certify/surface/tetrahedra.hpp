// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The faces of a complex of tetrahedra.
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kNoTet = 0xffffffffU;

/// A face and the tetrahedra that have it; the second may be kNoTet.
struct TetFace {
  std::array<std::uint32_t, 3> corners;  ///< ascending
  std::array<std::uint32_t, 2> tets;
};

/// Ascending. Requires: corners ascending, below `vertices`. Throws Reject unless every face is in
/// one or two tetrahedra and no two tetrahedra have the same corners. Cost: n log n.
std::vector<TetFace> list_faces(const std::vector<std::array<std::uint32_t, 4>>& tets,
                                std::size_t vertices);

/// Its place, kNoTet if there is none.
std::uint32_t find_face(const std::vector<TetFace>& faces,
                        const std::array<std::uint32_t, 3>& corners);

}  // namespace crest::certify
