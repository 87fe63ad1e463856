// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/neighbourhood.hpp"

#include <limits>

namespace crest::ridges {

NeighbourhoodCollector::NeighbourhoodCollector(const kernel::TriangleMesh& mesh)
    : mesh_(mesh), mark_(mesh.vertex_count(), 0) {}

bool NeighbourhoodCollector::add_ring(Index first, Index last, const Vec3& centre,
                                      double squared_radius) {
  const auto& points = mesh_.points();
  for (Index i = first; i < last; ++i) {
    for (Index w : mesh_.ring(found_[i])) {
      if (mark_[w] == stamp_) continue;
      mark_[w] = stamp_;
      const double x = points[w][0] - centre[0], y = points[w][1] - centre[1],
                   z = points[w][2] - centre[2];
      if (x * x + y * y + z * z <= squared_radius) found_.push_back(w);
    }
  }
  return found_.size() > last;
}

const std::vector<Index>& NeighbourhoodCollector::collect(Index v, const FitOptions& options) {
  constexpr double kEverywhere = std::numeric_limits<double>::infinity();
  ++stamp_;
  found_.assign(1, v);
  mark_[v] = stamp_;
  const Vec3 centre = mesh_.points()[v];
  const std::size_t wanted = static_cast<std::size_t>(options.min_points);
  Index first = 0;
  for (int ring = 1;; ++ring) {
    const bool by_radius = options.scale > 0 && ring > 2;
    if (options.scale <= 0) {
      if (options.rings > 0 ? ring > options.rings : found_.size() >= wanted) break;
    }
    const Index last = static_cast<Index>(found_.size());
    if (!add_ring(first, last, centre, by_radius ? options.scale * options.scale : kEverywhere))
      break;
    first = last;
  }
  return found_;
}

}  // namespace crest::ridges
