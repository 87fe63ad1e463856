// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The acute rule and the crossings on every edge: all of the graph's decisions at edges.
// Ambiguous edge: its principal vectors are exactly perpendicular. Conflict triangle: it has 1 or 3
// crossed sides of a colour (then of both: lemma 1 of certify/ridges_mesh/SPEC.md).
#include "algorithms/ridges/ridges.hpp"
#include "kernel/geometry/mesh_piece.hpp"

namespace crest::ridges {

/// Shapes: E edges, V vertices; colour 0 blue, 1 red. Of a piece: counts of what it owns; edges
/// with an end on the rim are 0.
struct EdgeStates {
  std::vector<std::int8_t> acute;     ///< +1: stored maximal vectors agree; -1: reverse one
  std::vector<std::uint8_t> crossed;  ///< bit c: crossed by a ridge of colour c (observation 2)
  std::vector<std::int8_t> extremality[2];  ///< sign of b0, b3 in the stored frame, never 0
  Index ambiguous_edges = 0;
  Index zero_extremalities[2] = {0, 0};
  StageCounts acute_counts, extremality_counts;

  bool is_crossed(Index edge, Colour c) const { return (crossed[edge] >> static_cast<int>(c)) & 1; }
  /// Number of sides of face f crossed by colour c.
  int crossings(const kernel::TriangleMesh& mesh, Index f, Colour c) const {
    int n = 0;
    for (Index e : mesh.face_edges()[f]) n += is_crossed(e, c);
    return n;
  }
  /// Lemma 1 of certify/ridges_mesh/SPEC.md: 1 or 3 crossings of each colour.
  bool conflict(const kernel::TriangleMesh& mesh, Index f) const {
    const auto& e = mesh.face_edges()[f];
    return acute[e[0]] * acute[e[1]] * acute[e[2]] < 0;
  }
};

/// guarded = false decides in plain double (0 counts as positive), to measure what exactness costs.
EdgeStates edge_states(const kernel::MeshPiece& piece, const std::vector<kernel::MongeForm>& forms,
                       bool guarded);

}  // namespace crest::ridges
