// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of vertices, edges and faces.
#include <array>
#include <cstdint>

namespace crest::kernel {

using Index = std::uint32_t;
inline constexpr Index kNone = 0xffffffffu;
using Triangle = std::array<Index, 3>;  ///< its vertices

}  // namespace crest::kernel
