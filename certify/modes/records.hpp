// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 6, modes, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kModes = 6, kModesVersion = 1;

struct ModesCertificate {
  std::vector<std::array<double, 3>> points;        ///< V
  std::vector<std::array<std::uint32_t, 4>> cells;  ///< C
  std::uint32_t distinct = 0, used = 0;
};

}  // namespace crest::certify
