// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 5, sharp-edges, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kSharpEdges = 5, kSharpEdgesVersion = 1;
inline constexpr std::uint32_t kLongestAngle = 100;  ///< characters

/// Claim sharp-edges: the edges whose faces' normals make an angle above a given one.
struct SharpEdgesCertificate {
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::array<double, 3>> positions;     ///< V
  std::string angle;                                ///< degrees, a decimal
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0;
  std::vector<std::uint32_t> sharp;   ///< numbers of edges, ascending
  std::uint32_t ties = 0;             ///< edges of exactly that angle
  std::uint32_t ends = 0, nodes = 0;  ///< vertices of one sharp edge; of three or more
  std::uint32_t patches = 0;
};

}  // namespace crest::certify
