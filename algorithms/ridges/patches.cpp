// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patches.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace crest::ridges {
namespace {

double distance(const Vec3& a, const Vec3& b) {
  return kernel::norm(kernel::operator-(a, b));
}

constexpr auto kLater = std::greater<std::pair<double, Index>>();

}  // namespace

PatchFace patch_face(const kernel::TriangleMesh& mesh, Index f) {
  PatchFace face{
      {}, mesh.faces()[f], {mesh.neighbour(f, 0), mesh.neighbour(f, 1), mesh.neighbour(f, 2)}};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Index v : face.corners) face.centroid[k] += mesh.points()[v][k];
    face.centroid[k] /= 3;
  }
  return face;
}

PatchGrower::PatchGrower(const kernel::TriangleMesh& mesh, std::span<const PatchFace> faces)
    : mesh_(mesh),
      of_all_(faces),
      face_mark_(mesh.face_count()),
      vertex_mark_(mesh.vertex_count(), 0) {}

double PatchGrower::one_ring_reach(Index seed) const {
  double reach = 0;
  for (Index v : mesh_.faces()[seed])
    for (Index f : mesh_.fan(v)) reach = std::max(reach, distance(face(f).centroid, centre_));
  return reach;
}

// With one shared side the third vertex must be new; with two, the triangle closes the gap around
// their common vertex; with three it would close a hole.
bool PatchGrower::stays_disk(const PatchFace& face) const {
  std::size_t shared = 0, apex = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (face.around[k] == kernel::kNone || !contains(face.around[k])) continue;
    ++shared;
    apex = (k + 2) % 3;
  }
  if (shared == 1) return vertex_mark_[face.corners[apex]] != stamp_;
  return shared == 2;
}

void PatchGrower::join(Index f, const PatchFace& face) {
  face_mark_[f].joined = stamp_;
  for (Index v : face.corners) vertex_mark_[v] = stamp_;
  faces_.push_back(f);
}

void PatchGrower::enqueue(const PatchFace& face, double limit, const std::vector<Index>& owner) {
  for (const Index g : face.around) {
    if (g == kernel::kNone || contains(g) || face_mark_[g].queued == stamp_) continue;
    if (owner[g] != kernel::kNone) continue;
    const double d = distance(this->face(g).centroid, centre_);
    if (d > limit) continue;
    face_mark_[g].queued = stamp_;
    asked_.push_back(g);
    queue_.push_back({d, g});
    std::push_heap(queue_.begin(), queue_.end(), kLater);
  }
}

const std::vector<Index>& PatchGrower::grow(Index seed, double size,
                                            const std::vector<Index>& owner) {
  ++stamp_;
  faces_.clear();
  asked_.clear();
  const PatchFace first = face(seed);
  centre_ = first.centroid;
  join(seed, first);
  face_mark_[seed].queued = stamp_;
  if (size <= 0) return faces_;
  const double limit = size * one_ring_reach(seed);
  queue_.clear();
  enqueue(first, limit, owner);
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), kLater);
    const Index f = queue_.back().second;
    queue_.pop_back();
    const PatchFace next = face(f);
    if (!stays_disk(next)) {
      face_mark_[f].queued = stamp_ - 1;  // a later neighbour may queue it again
      continue;
    }
    join(f, next);
    enqueue(next, limit, owner);
  }
  return faces_;
}

}  // namespace crest::ridges
