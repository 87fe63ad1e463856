// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A triangulation of a smooth surface (certify/ridges_smooth/SPEC.md, "Triangulation") that is
// refined where a proof fails.
//
// Refinement bisects longest edges (Rivara 1984): from a face walk across longest edges to the next
// face until two neighbours agree on their longest edge, bisect both, and start again until the
// face itself is bisected. Edges are totally ordered by (length, larger vertex, smaller vertex), so
// the walk ascends and ends; the mesh conforms after each step, and, the order being a function of
// the mesh, refinement is deterministic.
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::smooth_ridges {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;

/// Implicit: x, N. Parametric: U, V in [0, 1], in a periodic direction in [0, 1) and there a
/// multiple of 2^-52, so that lifted coordinates are exact; then zeros.
using Vertex = std::array<double, 6>;

/// Both see an edge from its vertex of smaller index; parametric: b lifted next to a.
struct EdgeRules {
  std::function<double(const Vertex& a, const Vertex& b)> length;  ///< or any increasing function
  std::function<Vertex(const Vertex& a, const Vertex& b)> place;   ///< implicit: near the midpoint
  std::array<bool, 2> periodic{};                                  ///< parametric
};

/// For each face the faces across its edges (edge i from corner i to corner i + 1), or kNone.
/// Throws: std::invalid_argument for an edge in more than two faces, or twice in one direction.
std::vector<std::array<Index, 3>> pair_edges(const std::vector<Triangle>& faces);

class Triangulation {
 public:
  Triangulation() = default;
  /// Shapes: F lifts (parametric; SPEC.md), or none (implicit).
  /// Requires: indices in range; rules.place if implicit.
  /// Throws: std::invalid_argument for an edge in more than two faces, or twice in one direction.
  Triangulation(std::vector<Vertex> vertices, std::vector<Triangle> faces,
                std::vector<std::uint8_t> lifts, EdgeRules rules);

  bool is_implicit() const { return lifts_.empty(); }
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Triangle>& faces() const { return faces_; }
  const std::vector<std::uint8_t>& lifts() const { return lifts_; }
  /// The face across edge i (from corner i to corner i + 1), or kNone.
  const std::vector<std::array<Index, 3>>& neighbours() const { return neighbours_; }
  /// Never used twice: what is known of a face holds as long as its id stands in its place.
  const std::vector<std::uint64_t>& ids() const { return ids_; }
  /// All faces made from now on have this id or a larger one.
  std::uint64_t next_id() const { return next_id_; }

  /// Corner k of a face; parametric: lifted, exactly.
  Vertex corner(Index face, std::size_t k) const;
  std::array<Vertex, 3> corners(Index face) const {
    return {corner(face, 0), corner(face, 1), corner(face, 2)};
  }
  /// The edge of `neighbour` that lies on `face`'s edge. Requires: they are neighbours there.
  std::size_t edge_towards(Index neighbour, Index face) const;

  /// Bisects at least each of the marked faces; faces keep their numbers or take new ones at the
  /// end. Cost: linear in the faces made, nearly always.
  void refine(const std::vector<Index>& marked);

  /// For each face the number of its component; components by their first face.
  std::vector<Index> face_components() const;
  int euler_characteristic() const;

 private:
  void choose_longest(Index face);
  void bisect(Index face);
  Index add_midpoint(Index face, std::size_t edge);
  Index split(Index face, std::size_t edge, Index middle, std::uint8_t lift);
  std::uint8_t lift_bits(Index face, std::size_t corner) const;
  std::uint8_t middle_lift(Index face, std::size_t edge, Index middle) const;
  Vertex lifted(Index face, std::size_t from, std::size_t to) const;
  void relink(Index face, Index old_neighbour, Index new_neighbour);

  std::vector<Vertex> vertices_;
  std::vector<Triangle> faces_;
  std::vector<std::uint8_t> lifts_;
  std::vector<std::array<Index, 3>> neighbours_;
  std::vector<std::uint8_t> longest_;
  std::vector<std::uint64_t> ids_;
  std::uint64_t next_id_ = 0;
  EdgeRules rules_;
};

}  // namespace crest::smooth_ridges
