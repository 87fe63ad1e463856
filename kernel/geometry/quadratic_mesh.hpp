// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A triangulated surface with a continuous function that is quadratic (or linear) on each face.
#include <array>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::kernel {

/// Shapes: V vertices, F faces, E edges in lexicographic order of (v0, v1), v0 < v1: this numbering
/// is part of the certificate format. Any 2-manifold with boundary, orientable or not, in any
/// number of components; Edge::f0 is the face of lower number, Edge::f1 the other or kNone
/// (unlike TriangleMesh, since faces may disagree about an edge's direction).
class QuadraticMesh {
 public:
  /// `values`: V. `midside`: F x 3, the value at the middle of side k, which joins corners k and
  /// (k + 1) % 3; empty for a function linear on each face.
  /// Guarantees: finite values and points; distinct corners; no two faces with the same corners;
  ///   every edge in one or two faces, which agree on its midside value; the link of every vertex
  ///   one cycle or one path. Positions play no further part: zero areas are accepted.
  /// Throws: InputError naming the element otherwise.
  /// Cost: O(V + F) memory, O(F) expected time.
  QuadraticMesh(std::vector<Vec3> points, std::vector<Triangle> faces, std::vector<double> values,
                const std::vector<std::array<double, 3>>& midside = {});

  Index vertex_count() const { return static_cast<Index>(points_.size()); }
  Index face_count() const { return static_cast<Index>(faces_.size()); }
  Index edge_count() const { return static_cast<Index>(edges_.size()); }
  bool linear() const { return edge_values_.empty(); }
  const std::vector<Vec3>& points() const { return points_; }
  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Side k of face f joins its corners k and (k + 1) % 3.
  const std::vector<std::array<Index, 3>>& face_edges() const { return face_edges_; }
  const std::vector<double>& values() const { return values_; }
  /// E values at the edges' midpoints; empty for a linear function.
  const std::vector<double>& edge_values() const { return edge_values_; }

 private:
  std::vector<Vec3> points_;
  std::vector<Triangle> faces_;
  std::vector<Edge> edges_;
  std::vector<std::array<Index, 3>> face_edges_;
  std::vector<double> values_, edge_values_;
};

}  // namespace crest::kernel
