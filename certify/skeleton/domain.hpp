// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The domain: triangles with a non-zero vector, glued along sides that are not zero, one vertex a
// fan (SPEC.md, step 1).
#include "certify/container/buffer.hpp"
#include "certify/skeleton/field.hpp"

namespace crest::certify::skeleton {

struct Domain {
  Buffer<u8> live;             ///< F: a corner has a vector that is not zero
  Buffer<u32> twin;            ///< 3F: kNone at the boundary, at walls and in dead triangles
  std::vector<u32> border;     ///< sides of one triangle alone, live or dead, ascending
  std::vector<u8> at_dead;     ///< 3F: the side borders on a dead triangle
  Buffer<u32> fan;             ///< 3F: fan of a live corner
  std::vector<u32> fan_start;  ///< a fan's corners are round[fan_start[i]] .. counter-clockwise
  Buffer<u32> round;           ///< corners of fans
  std::vector<u8> open;        ///< of fans: on the boundary
  std::vector<std::vector<u32>> loops;  ///< sides, each from its least on, by their least
  std::size_t dead = 0;

  /// The boundary side after this one: the first of the fan at its head.
  u32 next_side(u32 side) const { return round[fan_start[fan[next_corner(side)]]]; }
  /// Counter-clockwise.
  std::span<const u32> corners_of(u32 f) const {
    return std::span<const u32>(round.data(), round.size())
        .subspan(fan_start[f], fan_start[f + 1] - fan_start[f]);
  }
};

/// Throws Reject unless all triangles are positive, the whole is a surface, inner fans go round
/// once and boundary fans less than once. Cost: linear, plus sorting of edges.
Domain build_domain(const Field& field, SignLadder& sign);

}  // namespace crest::certify::skeleton
