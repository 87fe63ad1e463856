// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 14, coding, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kCoding = 14, kCodingVersion = 1;

/// What a stream says of positions.
enum class CodingMode : std::uint8_t { connectivity = 0, exact = 1, tolerance = 2 };

/// Claim coding: a stream decodes to a mesh.
struct CodingCertificate {
  std::vector<std::array<std::uint32_t, 3>> faces;      ///< F
  std::vector<std::array<std::uint64_t, 3>> positions;  ///< V, binary64 patterns: -0 is kept
  std::uint32_t dropped = 0;  ///< vertices of the file that no face uses, left out of the mesh
  CodingMode mode = CodingMode::exact;
  bool keep_order = false;  ///< decoded numbers are the mesh's
  double tolerance = 0;     ///< of mode tolerance, else 0

  std::vector<std::uint8_t> stream;        ///< the .cmc file
  std::vector<std::uint32_t> permutation;  ///< V: decoded vertex i is vertex permutation[i]
  std::uint32_t components = 0, handles = 0, loops = 0;
};

}  // namespace crest::certify
