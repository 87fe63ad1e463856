// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The topology of a marked set: which vertex may go, and Betti numbers
// (theory and proof: docs/feature-lines-topology.md).
#include "algorithms/feature_lines/marks.hpp"

namespace crest::feature_lines {

/// Changes between marked and unmarked along the neighbours of v: around the cycle at an interior
/// vertex (the paper's complexity c_i, always even), along the path at a boundary vertex.
inline Index transitions(const kernel::TriangleMesh& mesh, const Marks& marks, Index v) {
  const auto ring = mesh.ring(v);
  Index changes = 0;
  for (std::size_t k = 0; k + 1 < ring.size(); ++k)
    changes += static_cast<Index>(marks[ring[k]] ^ marks[ring[k + 1]]);
  if (!mesh.on_boundary(v)) changes += static_cast<Index>(marks[ring.back()] ^ marks[ring.front()]);
  return changes;
}

/// Whether v may change sides: the marked and the unmarked neighbours are one run each.
/// Guarantees: if so, taking v out of the marked set (or putting it in) keeps the homotopy type of
///   the marked subcomplex and of the complement; if not, it changes the Euler characteristic of
///   one of them. Law: does not depend on the mark of v; symmetric in marked and unmarked.
/// Not true: that c_i < 4 says the same (centres, isolated and boundary vertices differ).
/// Cost: O(valence). Source: paper 001, section 3.4.3, corrected.
inline bool is_simple(const kernel::TriangleMesh& mesh, const Marks& marks, Index v) {
  return transitions(mesh, marks, v) == (mesh.on_boundary(v) ? 1u : 2u);
}

inline Index marked_neighbours(const kernel::TriangleMesh& mesh, const Marks& marks, Index v) {
  Index n = 0;
  for (const Index w : mesh.ring(v)) n += marks[w];
  return n;
}

/// Of a complex: components, loops, closed surfaces; euler = b0 - b1 + b2.
struct Betti {
  int euler = 0;
  Index b0 = 0, b1 = 0, b2 = 0;
  bool operator==(const Betti&) const = default;
};

/// Of the subcomplex of all vertices, edges and faces of the mesh whose corners have this mark.
/// Cost: O(E).
Betti betti_numbers(const kernel::TriangleMesh& mesh, const Marks& marks, std::uint8_t mark);

/// Of the marked subcomplex, and of the one of the unmarked vertices, which the complement of the
/// first deforms to.
struct Topology {
  Betti marked, complement;
  bool operator==(const Topology&) const = default;
};
inline Topology topology_of(const kernel::TriangleMesh& mesh, const Marks& marks) {
  return {betti_numbers(mesh, marks, 1), betti_numbers(mesh, marks, 0)};
}

}  // namespace crest::feature_lines
