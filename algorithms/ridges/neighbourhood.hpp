// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The points a jet is fitted to: rings of neighbours around a vertex.
#include <vector>

#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {

/// Collects neighbourhoods of one mesh; one object a thread (it keeps marks).
class NeighbourhoodCollector {
 public:
  explicit NeighbourhoodCollector(const kernel::TriangleMesh& mesh);

  /// The vertex itself, then its neighbours ring by ring, each ring in the order of its parents'
  /// rings. options.scale > 0: all vertices within that Euclidean distance that are connected
  /// inside it (and at least two rings); rings > 0: that many rings; else rings until min_points.
  void collect(Index v, const FitOptions& options, std::vector<Index>& found);

 private:
  bool add_ring(std::vector<Index>& found, Index first, Index last, const Vec3& centre,
                double squared_radius);

  const kernel::TriangleMesh& mesh_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
};

}  // namespace crest::ridges
