// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patches.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace crest::ridges {

namespace {

std::shared_ptr<const std::vector<Vec3>> centroids_of(const kernel::TriangleMesh& mesh) {
  auto centroids = std::make_shared<std::vector<Vec3>>(mesh.face_count(), Vec3{});
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Vec3& centroid = (*centroids)[f];
    for (std::size_t k = 0; k < 3; ++k) {
      for (Index v : mesh.faces()[f]) centroid[k] += mesh.points()[v][k];
      centroid[k] /= 3;
    }
  }
  return centroids;
}

}  // namespace

PatchGrower::PatchGrower(const kernel::TriangleMesh& mesh)
    : mesh_(mesh),
      centroids_(centroids_of(mesh)),
      face_mark_(mesh.face_count(), 0),
      queued_mark_(mesh.face_count(), 0),
      vertex_mark_(mesh.vertex_count(), 0) {}

double PatchGrower::distance(Index f, Index g) const {
  return kernel::norm(kernel::operator-(centroid(f), centroid(g)));
}

double PatchGrower::one_ring_reach(Index seed) const {
  double reach = 0;
  for (Index v : mesh_.faces()[seed])
    for (Index f : mesh_.fan(v)) reach = std::max(reach, distance(f, seed));
  return reach;
}

// With one shared side the third vertex must be new; with two, the triangle closes the gap around
// their common vertex; with three it would close a hole.
bool PatchGrower::stays_disk(Index f) const {
  int shared = 0, apex = 0;
  for (int k = 0; k < 3; ++k) {
    const Index g = mesh_.neighbour(f, k);
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
  asked_.clear();
  join(seed);
  queued_mark_[seed] = stamp_;
  if (size <= 0) return faces_;
  const double limit = size * one_ring_reach(seed);
  const auto later = std::greater<std::pair<double, Index>>();
  queue_.clear();
  auto enqueue_neighbours = [&](Index f) {
    for (int k = 0; k < 3; ++k) {
      const Index g = mesh_.neighbour(f, k);
      if (g == kernel::kNone || contains(g) || queued_mark_[g] == stamp_) continue;
      if (owner[g] != kernel::kNone) continue;
      const double d = distance(g, seed);
      if (d > limit) continue;
      queued_mark_[g] = stamp_;
      asked_.push_back(g);
      queue_.push_back({d, g});
      std::push_heap(queue_.begin(), queue_.end(), later);
    }
  };
  enqueue_neighbours(seed);
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), later);
    const Index f = queue_.back().second;
    queue_.pop_back();
    if (!stays_disk(f)) {
      queued_mark_[f] = stamp_ - 1;  // a later neighbour may queue it again
      continue;
    }
    join(f);
    enqueue_neighbours(f);
  }
  return faces_;
}

}  // namespace crest::ridges
