// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Patches around umbilics: topological disks grown by a priority queue (paper 002, section 8.1).
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/ridges/edge_states.hpp"

namespace crest::ridges {

/// What growing looks at of a face.
struct PatchFace {
  Vec3 centroid;
  kernel::Triangle corners;
  std::array<Index, 3> around;  ///< TriangleMesh::neighbour
};
PatchFace patch_face(const kernel::TriangleMesh& mesh, Index f);

/// Grows disks of triangles; keeps its marks between calls. Copies work in several threads.
class PatchGrower {
 public:
  /// faces: of the whole mesh, for many disks: each of a hundred faces, which overlap. Outlives
  /// this.
  explicit PatchGrower(const kernel::TriangleMesh& mesh, std::span<const PatchFace> faces = {});

  /// The disk around seed: triangles join in the order of the distance of their centroids to the
  /// seed's, as long as the union stays a disk, up to size times the greatest such distance in the
  /// seed's one-ring (the triangles that share a vertex with it). Triangles with owner[f] != kNone
  /// do not join. Guarantees: the faces in order of joining, each prefix a disk that contains seed.
  const std::vector<Index>& grow(Index seed, double size, const std::vector<Index>& owner);
  /// The triangles without an owner on which that disk depends, besides the seed; some twice.
  const std::vector<Index>& asked() const { return asked_; }

  bool contains(Index f) const { return face_mark_[f].joined == stamp_; }
  PatchFace face(Index f) const { return of_all_.empty() ? patch_face(mesh_, f) : of_all_[f]; }

 private:
  bool stays_disk(const PatchFace& face) const;
  void join(Index f, const PatchFace& face);
  void enqueue(const PatchFace& face, double limit, const std::vector<Index>& owner);
  double one_ring_reach(Index seed) const;

  struct Mark {
    std::uint32_t joined = 0, queued = 0;
  };

  const kernel::TriangleMesh& mesh_;
  std::span<const PatchFace> of_all_;
  std::vector<Mark> face_mark_;
  std::vector<std::uint32_t> vertex_mark_;
  std::uint32_t stamp_ = 0;
  Vec3 centre_{};  ///< the seed's centroid
  std::vector<Index> faces_, asked_;
  std::vector<std::pair<double, Index>> queue_;  // a heap: distance, then face number
};

}  // namespace crest::ridges
