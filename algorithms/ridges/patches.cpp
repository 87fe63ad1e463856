// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patches.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace crest::ridges {

PatchGrower::PatchGrower(const kernel::TriangleMesh& mesh)
    : mesh_(mesh),
      face_mark_(mesh.face_count(), 0),
      queued_mark_(mesh.face_count(), 0),
      vertex_mark_(mesh.vertex_count(), 0) {}

Vec3 PatchGrower::centroid(Index f) const {
  Vec3 c{};
  for (Index v : mesh_.faces()[f])
    for (std::size_t k = 0; k < 3; ++k) c[k] += mesh_.points()[v][k];
  for (double& x : c) x /= 3;
  return c;
}

double PatchGrower::distance(Index f, const Vec3& from) const {
  const Vec3 c = centroid(f);
  const double x = c[0] - from[0], y = c[1] - from[1], z = c[2] - from[2];
  return std::sqrt(x * x + y * y + z * z);
}

double PatchGrower::one_ring_reach(Index seed) const {
  const Vec3 c = centroid(seed);
  double reach = 0;
  for (Index v : mesh_.faces()[seed])
    for (Index f : mesh_.fan(v)) reach = std::max(reach, distance(f, c));
  return reach;
}

// With one shared side the third vertex must be new; with two, the triangle closes the gap around
// their common vertex; with three it would close a hole.
bool PatchGrower::stays_disk(Index f) const {
  int shared = 0, apex = 0;
  for (int k = 0; k < 3; ++k) {
    const Index g = mesh_.neighbor(f, k);
    if (g != kernel::kNone && contains(g)) {
      ++shared;
      apex = (k + 2) % 3;
    }
  }
  if (shared == 1) return vertex_mark_[mesh_.faces()[f][static_cast<std::size_t>(apex)]] != stamp_;
  return shared == 2;
}

void PatchGrower::join(Index f) {
  face_mark_[f] = stamp_;
  for (Index v : mesh_.faces()[f]) vertex_mark_[v] = stamp_;
  faces_.push_back(f);
}

const std::vector<Index>& PatchGrower::grow(Index seed, double size,
                                            const std::vector<Index>& owner) {
  ++stamp_;
  faces_.clear();
  join(seed);
  queued_mark_[seed] = stamp_;
  if (size <= 0) return faces_;
  const Vec3 centre = centroid(seed);
  const double limit = size * one_ring_reach(seed);
  using Entry = std::pair<double, Index>;  // ties by face number
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  auto enqueue_neighbours = [&](Index f) {
    for (int k = 0; k < 3; ++k) {
      const Index g = mesh_.neighbor(f, k);
      if (g == kernel::kNone || contains(g) || queued_mark_[g] == stamp_) continue;
      if (owner[g] != kernel::kNone) continue;
      const double d = distance(g, centre);
      if (d > limit) continue;
      queued_mark_[g] = stamp_;
      queue.push({d, g});
    }
  };
  enqueue_neighbours(seed);
  while (!queue.empty()) {
    const Index f = queue.top().second;
    queue.pop();
    if (!stays_disk(f)) {
      queued_mark_[f] = stamp_ - 1;  // a later neighbour may queue it again
      continue;
    }
    join(f);
    enqueue_neighbours(f);
  }
  return faces_;
}

std::array<Index, 2> contour_crossings(const kernel::TriangleMesh& mesh, const EdgeStates& states,
                                       const std::vector<Index>& faces, const PatchGrower& grower) {
  std::array<Index, 2> count{};
  for (Index f : faces)
    for (int k = 0; k < 3; ++k) {
      const Index g = mesh.neighbor(f, k);
      if (g != kernel::kNone && grower.contains(g)) continue;
      const Index e = mesh.face_edges()[f][static_cast<std::size_t>(k)];
      count[0] += states.is_crossed(e, Colour::blue);
      count[1] += states.is_crossed(e, Colour::red);
    }
  return count;
}

}  // namespace crest::ridges
