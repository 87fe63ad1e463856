// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The points a jet is fitted to: rings of neighbours around a vertex.
#include <vector>

#include "algorithms/ridges/lanes.hpp"
#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {

/// Collects neighbourhoods of one mesh; one object a thread (it keeps marks).
class NeighbourhoodCollector {
 public:
  explicit NeighbourhoodCollector(const kernel::TriangleMesh& mesh);

  /// The vertex itself, then its neighbours ring by ring, each ring in the order of its parents'
  /// rings. options.scale > 0: all vertices within that Euclidean distance that are connected
  /// inside it (and at least two rings); rings > 0: that many rings; else rings until min_points.
  /// With options.errors then the points of the second fit: the same with the radius times 1.25,
  /// the points times its square; at least one ring more.
  void collect(Index v, const FitOptions& options, Support& found);

 private:
  void widen(const FitOptions& options, const Vec3& centre, Index last_ring,
             std::vector<Index>& found);
  bool add_ring(std::vector<Index>& found, Index first, Index last, const Vec3& centre,
                double squared_radius);

  const kernel::TriangleMesh& mesh_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
};

}  // namespace crest::ridges
