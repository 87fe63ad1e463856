// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Patches around umbilics: topological disks grown by a priority queue (paper 002, section 8.1).
#include <array>
#include <utility>
#include <vector>

#include "algorithms/ridges/edge_states.hpp"

namespace crest::ridges {

/// Grows disks of triangles; keeps its marks between calls. Copies work in several threads.
class PatchGrower {
 public:
  explicit PatchGrower(const kernel::TriangleMesh& mesh);

  /// The disk around seed: triangles join in the order of the distance of their centroids to the
  /// seed's, as long as the union stays a disk, up to size times the greatest such distance in the
  /// seed's one-ring (the triangles that share a vertex with it). Triangles with owner[f] != kNone
  /// do not join. Guarantees: the faces in order of joining, each prefix a disk that contains seed.
  const std::vector<Index>& grow(Index seed, double size, const std::vector<Index>& owner);
  /// The triangles without an owner on which that disk depends, besides the seed; some twice.
  const std::vector<Index>& asked() const { return asked_; }

  bool contains(Index f) const { return face_mark_[f] == stamp_; }
  Vec3 centroid(Index f) const;

 private:
  std::array<Index, 3> around(Index f) const;
  bool stays_disk(Index f, const std::array<Index, 3>& around) const;
  void join(Index f);
  double one_ring_reach(Index seed) const;
  double distance(Index f) const;

  const kernel::TriangleMesh& mesh_;
  std::vector<std::uint32_t> face_mark_, queued_mark_, vertex_mark_;
  std::uint32_t stamp_ = 0;
  Vec3 centre_{};  ///< the seed's centroid
  std::vector<Index> faces_, asked_;
  std::vector<std::pair<double, Index>> queue_;  // a heap: distance, then face number
};

}  // namespace crest::ridges
