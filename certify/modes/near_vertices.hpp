// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vertices of the surfaces: whether the mode there is near the level (SPEC.md, theorem 16 (ii)).
#include "certify/modes/positions.hpp"

namespace crest::certify::modes {

/// |mode - level| of what is near: below 10^-12.
inline constexpr double kNear = 0x1p-40;

/// Whether the tensor at a point of a simplex is not zero and its mode is near the + or the -
/// level. The last corner has what is left of 1. Exact.
template <std::size_t n>
bool is_near(const LevelContext& context, const std::array<u32, n>& corners,
             const std::array<double, n - 1>& weights, int level, ExactTensors& exact);

/// Counts a level's vertices that are near.
class NearVertices {
 public:
  /// Throws Reject unless each inner vertex is in the closed cell of a witness with pieces of its
  /// level, and they come in their order.
  NearVertices(const LevelContext& context, const Positions& positions);

  std::size_t all() const;
  /// The roots of a leaf; none of another node.
  u32 on_edge(const EdgeNode& edge, Worker& worker) const;
  /// The points of a node's own arcs.
  u32 on_face(u32 face, Worker& worker) const;
  bool inside(const InnerVertex& vertex, Worker& worker) const;

 private:
  const LevelContext& context_;
  const Positions& positions_;
  std::vector<u32> cell_of_;  ///< of each witness
};

}  // namespace crest::certify::modes
