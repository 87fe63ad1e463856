// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The points a jet is fitted to: rings of neighbours around a vertex.
#include <vector>

#include "algorithms/ridges/lanes.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "kernel/geometry/mesh_piece.hpp"

namespace crest::ridges {

/// Collects neighbourhoods of one piece; one object a thread (it keeps marks).
class NeighbourhoodCollector {
 public:
  /// creases: V (creases.hpp), or none.
  NeighbourhoodCollector(const kernel::MeshPiece& piece, const std::vector<std::uint8_t>& creases);

  /// The vertex itself, then its neighbours ring by ring, each ring in the order of its parents'
  /// rings. options.scale > 0: all vertices within that Euclidean distance that are connected
  /// inside it (and at least two rings); rings > 0: that many rings; else rings until min_points,
  /// or kSmallestSupport if those reach a crease. With options.errors then the points of the second
  /// fit: the same with the radius times 1.25, the points times its square; at least one ring more.
  /// Returns false where the rim has cut it short.
  bool collect(Index v, const FitOptions& options, Support& found);

 private:
  std::size_t wanted(const FitOptions& options, const std::vector<Index>& found) const;
  void widen(const FitOptions& options, const Vec3& centre, Index last_ring,
             std::vector<Index>& found);
  bool add_ring(std::vector<Index>& found, Index first, Index last, const Vec3& centre,
                double squared_radius);

  const kernel::MeshPiece piece_;
  const std::vector<std::uint8_t>& creases_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
  bool at_rim_ = false;  ///< a vertex was asked for its ring that is on the rim
};

}  // namespace crest::ridges
