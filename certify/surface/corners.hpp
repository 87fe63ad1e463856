// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corners and sides of triangles, by number.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace crest::certify {

using Corners = std::array<std::uint32_t, 3>;
using Faces = std::span<const Corners>;

inline constexpr std::uint32_t kNone = 0xffffffffU;

/// Corner c = 3 f + i is corner i of face f; side c runs from corner i to the next one, and is
/// across from the corner before.
constexpr std::uint32_t next_corner(std::uint32_t c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
constexpr std::uint32_t previous_corner(std::uint32_t c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}
inline std::uint32_t vertex_of(Faces faces, std::uint32_t corner) {
  return faces[corner / 3][corner % 3];
}

}  // namespace crest::certify
