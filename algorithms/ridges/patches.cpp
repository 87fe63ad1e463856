// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patches.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace crest::ridges {

PatchGrower::PatchGrower(const kernel::TriangleMesh& mesh)
    : mesh_(mesh),
      face_mark_(mesh.face_count(), 0),
      queued_mark_(mesh.face_count(), 0),
      vertex_mark_(mesh.vertex_count(), 0) {}

// Most faces are in no patch: theirs are not kept.
Vec3 PatchGrower::centroid(Index f) const {
  Vec3 centroid{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Index v : mesh_.faces()[f]) centroid[k] += mesh_.points()[v][k];
    centroid[k] /= 3;
  }
  return centroid;
}

double PatchGrower::distance(Index f) const {
  return kernel::norm(kernel::operator-(centroid(f), centre_));
}

double PatchGrower::one_ring_reach(Index seed) const {
  double reach = 0;
  for (Index v : mesh_.faces()[seed])
    for (Index f : mesh_.fan(v)) reach = std::max(reach, distance(f));
  return reach;
}

std::array<Index, 3> PatchGrower::around(Index f) const {
  return {mesh_.neighbour(f, 0), mesh_.neighbour(f, 1), mesh_.neighbour(f, 2)};
}

// With one shared side the third vertex must be new; with two, the triangle closes the gap around
// their common vertex; with three it would close a hole.
bool PatchGrower::stays_disk(Index f, const std::array<Index, 3>& around) const {
  std::size_t shared = 0, apex = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (around[k] == kernel::kNone || !contains(around[k])) continue;
    ++shared;
    apex = (k + 2) % 3;
  }
  if (shared == 1) return vertex_mark_[mesh_.faces()[f][apex]] != stamp_;
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
  asked_.clear();
  centre_ = centroid(seed);
  join(seed);
  queued_mark_[seed] = stamp_;
  if (size <= 0) return faces_;
  const double limit = size * one_ring_reach(seed);
  const auto later = std::greater<std::pair<double, Index>>();
  queue_.clear();
  auto enqueue = [&](const std::array<Index, 3>& faces) {
    for (const Index g : faces) {
      if (g == kernel::kNone || contains(g) || queued_mark_[g] == stamp_) continue;
      if (owner[g] != kernel::kNone) continue;
      const double d = distance(g);
      if (d > limit) continue;
      queued_mark_[g] = stamp_;
      asked_.push_back(g);
      queue_.push_back({d, g});
      std::push_heap(queue_.begin(), queue_.end(), later);
    }
  };
  enqueue(around(seed));
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), later);
    const Index f = queue_.back().second;
    queue_.pop_back();
    const std::array<Index, 3> next = around(f);
    if (!stays_disk(f, next)) {
      queued_mark_[f] = stamp_ - 1;  // a later neighbour may queue it again
      continue;
    }
    join(f);
    enqueue(next);
  }
  return faces_;
}

}  // namespace crest::ridges
