// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A triangulation that half-edge collapses make coarser: a vertex moves onto a neighbour, its
// triangles follow, two of them (at the boundary one) vanish. The others keep their numbers and
// the order of their corners, so half-edges outside the vertex' star keep theirs.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/vector_fields/boundary.hpp"

namespace crest::vector_fields {

/// What a half-edge of the boundary is, whatever triangle it belongs to.
struct BoundaryEdge {
  Index ordinal = kNone;  ///< of its tail, along the loops of the input
  EdgeRegions regions;
};

/// A collapse, an edge flipped, or a vertex taken out, that keeps the domain and all triangles
/// positive.
struct Collapse {
  Index from = kNone, to = kNone;
  std::vector<Index> star;  ///< triangles around `from`, counter-clockwise from `to` on
  std::array<Index, 2> gone{kNone, kNone};  ///< those that vanish; at the boundary one, twice
  HalfEdge flipped = kNone;                 ///< of a flip, whose star is both its triangles
  /// Of a vertex taken out: what the star's first triangles become. `to`: none.
  std::vector<std::array<Index, 3>> filling = {};
};

enum class CollapseRefusal : std::uint8_t { none, geometry, boundary };

class CollapseMesh {
 public:
  /// Requires: both outlive the mesh.
  CollapseMesh(const Domain& domain, const Boundary& boundary);

  Index triangle_count() const { return static_cast<Index>(corners_.size() / 3); }
  std::size_t vertex_count() const { return leaving_.size(); }
  Index live_triangles() const { return live_; }
  bool alive(Index t) const { return alive_[t] != 0; }
  Index from(HalfEdge h) const { return corners_[h]; }
  Index to(HalfEdge h) const { return corners_[Domain::next(h)]; }
  HalfEdge twin(HalfEdge h) const { return twins_[h]; }
  const Vec2& point(Index v) const { return domain_.point(v); }
  const Vec2& vector(Index v) const { return domain_.vector(v); }
  kernel::FieldOnTriangle data(Index t) const { return data(t, kNone, kNone); }
  kernel::FieldOnTriangle data(const std::array<Index, 3>& corners) const;
  /// The same with `from` replaced by `to`.
  kernel::FieldOnTriangle data(Index t, Index from, Index to) const;
  const BoundaryEdge& boundary_edge(HalfEdge h) const { return boundary_edges_[h]; }
  /// The half-edge of the boundary that has an ordinal.
  HalfEdge edge_of_ordinal(Index ordinal) const { return by_ordinal_[ordinal]; }

  /// Whether both are left and share an edge.
  bool adjacent(Index from, Index to) const;
  /// Vertices that take part in no collapse.
  void fix(Index vertex) { fixed_[vertex] = 1; }
  /// Vertices that stay; others may move onto them. Requires: of one fan.
  void keep(Index vertex) { kept_[vertex] = 1; }
  /// A half-edge that leaves a vertex that is left.
  HalfEdge leaving(Index vertex) const { return leaving_[vertex]; }
  /// Whether `from` may collapse to `to`, its neighbour, and how.
  CollapseRefusal plan(Index from, Index to, Collapse& plan) const;
  /// Whether the edge may become the other diagonal of its triangles, and how.
  bool plan_flip(HalfEdge side, Collapse& plan) const;
  /// Whether a vertex may be taken out, and the corners of the hole, counter-clockwise, at the
  /// boundary from the next one to the one before; leaves the filling open. Requires: not a vertex
  /// that stays.
  bool plan_hole(Index vertex, std::vector<Index>& corners, Collapse& plan) const;
  /// What a triangle of the star that does not vanish will be.
  kernel::FieldOnTriangle data_after(const Collapse& plan, Index t) const;
  /// Whether no collapse moves the vertex.
  bool stays(Index vertex) const { return fixed_[vertex] != 0 || kept_[vertex] != 0; }
  /// Half-edges that leave a vertex of one fan, counter-clockwise.
  void fan(Index vertex, std::vector<HalfEdge>& leaving) const;

  void apply(const Collapse& plan);
  /// Takes back the last collapse or flip.
  void undo();

  /// The triangles that are left, in their order; `vertex_of`: the numbers of their vertices in the
  /// input.
  PlanarField field(std::vector<Index>& vertex_of) const;

 private:
  CollapseRefusal plan_boundary(Index from, Index to, Collapse& plan) const;
  bool passes_boundary(const std::vector<HalfEdge>& fan) const;
  bool linked(Index from, Index to, std::size_t common) const;
  bool positive(const Collapse& plan) const;
  void apply_flip(HalfEdge side);
  void apply_filling(const Collapse& plan);
  void set_twin(HalfEdge h, HalfEdge twin, const BoundaryEdge& edge);
  void set_leaving(Index vertex, HalfEdge h);

  /// What one collapse changed, to take it back.
  struct Journal {
    std::vector<std::pair<HalfEdge, Index>> corners, twins;
    std::vector<std::pair<HalfEdge, BoundaryEdge>> edges;
    std::vector<std::pair<Index, HalfEdge>> leaving, ordinals;
    std::array<Index, 2> gone{kNone, kNone};
  };

  const Domain& domain_;
  std::vector<Index> corners_;
  std::vector<HalfEdge> twins_, leaving_;  ///< leaving_: one that leaves each vertex
  std::vector<std::uint8_t> alive_, fixed_, kept_;
  std::vector<BoundaryEdge> boundary_edges_;
  std::vector<HalfEdge> by_ordinal_;
  Index live_ = 0;
  Journal journal_;
  mutable std::vector<HalfEdge> fan_, other_fan_;
  mutable std::vector<Index> stamps_;
  mutable Index stamp_ = 0;
};

}  // namespace crest::vector_fields
