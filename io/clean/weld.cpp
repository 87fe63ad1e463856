// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/weld.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernel/geometry/equal_points.hpp"
#include "kernel/predicates/within.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Vec3;

/// The vertices that stay, by cells of twice the distance: those within the distance of a point are
/// in its cell or the ones around it, rounding of the quotients included.
class Grid {
 public:
  Grid(const std::vector<Vec3>& points, double distance) : points_(points), distance_(distance) {}

  /// The lowest of those within the distance, or nobody.
  Index nearby(const Vec3& p) const {
    Index lowest = kNone;
    const Vec3 centre = cell(p);
    for (int i = 0; i < 27; ++i) {
      const Vec3 around = {centre[0] + (i % 3 - 1), centre[1] + (i / 3 % 3 - 1),
                           centre[2] + (i / 9 - 1)};
      const auto found = cells_.find(around);
      if (found == cells_.end()) continue;
      for (const Index v : found->second)
        if (v < lowest && kernel::within(points_[v], p, distance_)) lowest = v;
    }
    return lowest;
  }
  void add(Index v) { cells_[cell(points_[v])].push_back(v); }

 private:
  /// A coordinate far beyond the distance is a cell of its own: only equal ones are within it.
  Vec3 cell(const Vec3& p) const {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
      const double quotient = std::floor(0.5 * p[k] / distance_);
      result[k] = (std::isfinite(quotient) ? quotient : p[k]) + 0.0;
    }
    return result;
  }

  const std::vector<Vec3>& points_;
  double distance_;
  std::map<Vec3, std::vector<Index>> cells_;
};

std::vector<Index> lowest_within(const std::vector<Vec3>& points, double distance) {
  if (distance == 0) return kernel::first_equal(points);
  std::vector<Index> joined(points.size());
  Grid grid(points, distance);
  for (Index v = 0; v < points.size(); ++v) {
    const Index lowest = grid.nearby(points[v]);
    joined[v] = std::min(v, lowest);
    if (lowest == kNone) grid.add(v);
  }
  return joined;
}

}  // namespace

std::size_t weld(Surface& surface, double distance) {
  const std::vector<Index> joined = lowest_within(surface.points, distance);
  std::vector<Index> number(joined.size());
  Index stays = 0;
  for (Index v = 0; v < joined.size(); ++v) {
    if (joined[v] != v) {
      number[v] = number[joined[v]];
      continue;
    }
    surface.points[stays] = surface.points[v];
    surface.point_of[stays] = surface.point_of[v];
    number[v] = stays++;
  }
  const std::size_t gone = joined.size() - stays;
  surface.points.resize(stays);
  surface.point_of.resize(stays);
  for (kernel::Triangle& face : surface.faces)
    for (Index& v : face) v = number[v];
  return gone;
}

}  // namespace crest::io
