// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate curves inside a tet: arcs of the conic v . Tbar v = 0 on which the four coordinate
// forms have one sign, between the face points (theory: README.md).
//
// The conic is seen from a point inside it: the direction of v modulo that point orders its points.
// Between neighbours no coordinate vanishes where the others agree, so one sample decides an arc.
// Stages: doubles with error radii; exact (degenerate_order.hpp).
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/modes/degenerate_conic.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::modes {

struct TetPoint {
  std::uint32_t id;
  std::size_t opposite;  ///< the corner that its face is opposite to
  DegenerateType type;
  kernel::Vector3<Ball> v;
};

struct TetArc {
  std::array<std::uint32_t, 2> ends;            ///< ids
  std::vector<std::array<double, 4>> interior;  ///< barycentric, from the first end to the second
};

struct TetArcs {
  std::vector<TetArc> arcs;
  std::optional<SpecialReason> special;  ///< dependent or line_pair
  bool decided = true;  ///< false: some v is too wide to tell the points of its face apart
};

/// Requires: the four faces have no special points; points: all of theirs, distinct.
/// Guarantees: every point ends one arc, unless special or undecided.
TetArcs tet_arcs(const std::array<const Tensor*, 4>& corners,
                 const std::array<kernel::Vec3, 4>& positions, std::span<const TetPoint> points);

}  // namespace crest::modes
