// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An oriented triangle 2-manifold with or without boundary, indexed for walking.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::kernel {

/// Undirected edge: v0 < v1. f0 is the face in which v0 precedes v1, f1 the face in which v1
/// precedes v0; one of them is kNone on the boundary.
struct Edge {
  Index v0, v1;
  Index f0, f1;
};

/// Shapes: V points, F faces, E edges sorted by (v0, v1): this numbering is part of the
/// certificate format (certify/SPEC.md).
class TriangleMesh {
 public:
  TriangleMesh() = default;
  /// Requires: indices below points.size().
  /// Guarantees: finite coordinates; no degenerate (repeated vertex or exactly zero area) or
  ///   duplicate face; every edge in at most two faces, consistently oriented; every vertex has
  ///   one fan of faces (no isolated vertex).
  /// Throws: InputError naming the element otherwise.
  /// Cost: O(V + F) memory and expected time.
  TriangleMesh(std::vector<Vec3> points, std::vector<Triangle> faces);

  Index vertex_count() const { return static_cast<Index>(points_.size()); }
  Index face_count() const { return static_cast<Index>(faces_.size()); }
  Index edge_count() const { return static_cast<Index>(edges_.size()); }
  const std::vector<Vec3>& points() const { return points_; }
  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Side k of face f joins its corners k and (k + 1) % 3.
  const std::vector<std::array<Index, 3>>& face_edges() const { return face_edges_; }
  /// The face across side k of face f, or kNone.
  Index neighbour(Index f, int k) const {
    const Edge& e = edges_[face_edges_[f][static_cast<std::size_t>(k)]];
    return e.f0 == f ? e.f1 : e.f0;
  }

  /// Neighbours of v counter-clockwise (seen from outside); on the boundary the first and the
  /// last are the boundary neighbours. Face j of the fan has corners v, ring[j], ring[j + 1].
  /// An interior fan starts in the face of lowest index, at the corner after v.
  std::span<const Index> ring(Index v) const {
    return {ring_.data() + ring_begin_[v], ring_.data() + ring_begin_[v + 1]};
  }
  /// The faces of that fan: fan(v)[j] has corners v, ring(v)[j], ring(v)[j + 1] (cyclically).
  std::span<const Index> fan(Index v) const {
    return {fan_.data() + ring_begin_[v],
            fan_.data() + ring_begin_[v + 1] - (on_boundary(v) ? 1 : 0)};
  }
  bool on_boundary(Index v) const { return boundary_vertex_[v] != 0; }
  Index boundary_loops() const { return boundary_loops_; }
  Index components() const { return components_; }
  bool closed() const { return boundary_loops_ == 0; }
  int euler_characteristic() const {
    return static_cast<int>(vertex_count()) - static_cast<int>(edge_count()) +
           static_cast<int>(face_count());
  }

 private:
  void build_edges();
  void build_rings();
  void count_components_and_loops();

  std::vector<Vec3> points_;
  std::vector<Triangle> faces_;
  std::vector<Edge> edges_;
  std::vector<std::array<Index, 3>> face_edges_;
  std::vector<Index> ring_, fan_, ring_begin_;  // fan_ has a gap after a boundary fan
  std::vector<std::uint8_t> boundary_vertex_;
  Index boundary_loops_ = 0, components_ = 0;
};

}  // namespace crest::kernel
