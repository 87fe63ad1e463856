// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The domain of the flow: the triangles with a vector that is not zero, cut along edges where the
// field is zero at both ends (walls). A vertex where several fans meet is a point a fan.
#include <vector>

#include "algorithms/vector_fields/planar_field.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

/// Side k of triangle t, 3 t + k, from corner k to corner k + 1; the triangle is at its left.
using HalfEdge = Index;

/// The triangles around a vertex within one fan, each by the half-edge that leaves the vertex, in
/// counter-clockwise order. An open fan starts at the boundary.
struct Fan {
  std::vector<HalfEdge> leaving;
  bool closed = false;
};

class Domain {
 public:
  /// Requires: `field` outlives the domain.
  /// Throws: kernel::InputError if a number is not finite, a triangle is not counter-clockwise, an
  /// edge has more than two triangles or two on one side, or all vectors are zero.
  /// Cost: O(V + T).
  explicit Domain(const PlanarField& field);

  const PlanarField& field() const { return field_; }
  Index triangle_count() const { return static_cast<Index>(field_.triangles.size()); }
  Index from(HalfEdge h) const { return field_.triangles[h / 3][h % 3]; }
  Index to(HalfEdge h) const { return from(next(h)); }
  static HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static HalfEdge previous(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// The same edge from the other side; kNone at the boundary.
  HalfEdge twin(HalfEdge h) const { return twins_[h]; }
  /// Whether some vector of the triangle is not zero.
  bool live(Index t) const { return dead_.empty() || dead_[t] == 0; }
  /// Whether the half-edge borders on a triangle without flow.
  bool at_region(HalfEdge h) const { return !region_border_.empty() && region_border_[h] != 0; }
  const Vec2& point(Index v) const { return field_.points[v]; }
  const Vec2& vector(Index v) const { return field_.vectors[v]; }
  kernel::FieldOnTriangle corners(Index t) const {
    const auto& [a, b, c] = field_.triangles[t];
    return {{point(a), point(b), point(c)}, {vector(a), vector(b), vector(c)}};
  }
  bool is_zero(Index v) const { return field_.vectors[v][0] == 0 && field_.vectors[v][1] == 0; }

  /// The fan that holds h at the vertex it leaves.
  Fan fan(HalfEdge h) const;
  /// The boundary half-edge after a boundary half-edge, the domain at the left.
  HalfEdge next_on_boundary(HalfEdge h) const;
  /// Boundary half-edges in loops; each loop starts at its smallest, loops stand in the order of
  /// these.
  std::vector<std::vector<HalfEdge>> loops() const;

  /// As the file has it: of all triangles, uncut.
  int euler_characteristic() const { return euler_characteristic_; }
  Index components() const { return components_; }
  Index zero_triangles() const { return zero_triangles_; }
  Index zero_regions() const { return zero_regions_; }
  Index zero_edges() const { return zero_edges_; }  ///< inner ones that are cut

 private:
  void check() const;
  void link();
  void count();
  void cut();

  const PlanarField& field_;
  std::vector<HalfEdge> twins_;
  std::vector<std::uint8_t> dead_, region_border_;  ///< empty: none
  int euler_characteristic_ = 0;
  Index components_ = 0, zero_triangles_ = 0, zero_regions_ = 0, zero_edges_ = 0;
};

}  // namespace crest::vector_fields
