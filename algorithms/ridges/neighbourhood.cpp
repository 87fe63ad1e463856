// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/neighbourhood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/ridges/creases.hpp"

namespace crest::ridges {

using kernel::operator-;
namespace {
constexpr double kEverywhere = std::numeric_limits<double>::infinity();
}  // namespace

NeighbourhoodCollector::NeighbourhoodCollector(const kernel::MeshPiece& piece,
                                               const std::vector<std::uint8_t>& creases)
    : piece_(piece), creases_(creases), mark_(piece.mesh().vertex_count(), 0) {}

/// How many points the support is to have, if it has reached found by rings.
std::size_t NeighbourhoodCollector::wanted(const FitOptions& options,
                                           const std::vector<Index>& found) const {
  const auto points = static_cast<std::size_t>(options.min_points);
  const bool at_crease =
      !creases_.empty() && found.size() >= kSmallestSupport &&
      std::any_of(found.begin(), found.end(), [&](Index w) { return creases_[w]; });
  return at_crease ? std::min<std::size_t>(points, kSmallestSupport) : points;
}

bool NeighbourhoodCollector::add_ring(std::vector<Index>& found, Index first, Index last,
                                      const Vec3& centre, double squared_radius) {
  const kernel::TriangleMesh& mesh = piece_.mesh();
  const auto& points = mesh.points();
  for (Index i = first; i < last; ++i) {
    at_rim_ = at_rim_ || !piece_.is_inner(found[i]);
    for (Index w : mesh.ring(found[i])) {
      if (mark_[w] == stamp_) continue;
      mark_[w] = stamp_;
      const Vec3 d = points[w] - centre;
      if (kernel::dot(d, d) <= squared_radius) found.push_back(w);
    }
  }
  return found.size() > last;
}

bool NeighbourhoodCollector::collect(Index v, const FitOptions& options, Support& support) {
  at_rim_ = false;
  std::vector<Index>& found = support.points;
  ++stamp_;
  found.assign(1, v);
  mark_[v] = stamp_;
  const Vec3 centre = piece_.mesh().points()[v];
  Index first = 0;
  for (int ring = 1;; ++ring) {
    const bool by_radius = options.scale > 0 && ring > 2;
    if (options.scale <= 0) {
      if (options.rings > 0 ? ring > options.rings : found.size() >= wanted(options, found)) break;
    }
    const Index last = static_cast<Index>(found.size());
    if (!add_ring(found, first, last, centre,
                  by_radius ? options.scale * options.scale : kEverywhere))
      break;
    first = last;
  }
  support.inner = found.size();
  if (options.errors) widen(options, centre, first, found);
  return !at_rim_;
}

void NeighbourhoodCollector::widen(const FitOptions& options, const Vec3& centre, Index last_ring,
                                   std::vector<Index>& found) {
  constexpr double kWider = 1.25;
  const std::size_t inner = found.size();
  if (options.scale > 0) {  // points once too far may be near enough now
    ++stamp_;
    for (const Index w : found) mark_[w] = stamp_;
    const double radius = kWider * options.scale;
    Index first = 0;
    for (Index last = 0; last != found.size();) {
      last = static_cast<Index>(found.size());
      add_ring(found, first, last, centre, radius * radius);
      first = last;
    }
    if (found.size() > inner) return;
    ++stamp_;
    for (const Index w : found) mark_[w] = stamp_;
    add_ring(found, 0, static_cast<Index>(inner), centre, kEverywhere);
    return;
  }
  const double wider = kWider * kWider * static_cast<double>(wanted(options, found));
  const int rings = std::max(1, static_cast<int>(std::lround((kWider - 1) * options.rings)));
  Index first = last_ring;
  for (int ring = 1;; ++ring) {
    const Index last = static_cast<Index>(found.size());
    if (!add_ring(found, first, last, centre, kEverywhere)) return;
    first = last;
    if (options.rings > 0 ? ring == rings : static_cast<double>(found.size()) >= wider) return;
  }
}

}  // namespace crest::ridges
