// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The steps of claim 3 (certify/SPEC.md, "What the checker proves, in order").
#include <array>
#include <cstdint>
#include <vector>

#include "certify/certificate.hpp"
#include "certify/sign_ladder.hpp"

namespace crest::certify::reeb {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// Corner 3 t + i is node i of triangle t; the side of the same number leads from it to the next.
constexpr std::uint32_t next_corner(std::uint32_t c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
constexpr std::uint32_t previous_corner(std::uint32_t c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}
inline std::uint32_t node_of(const Triangles& triangles, std::uint32_t corner) {
  return triangles[corner / 3][corner % 3];
}

/// Triangles glued along equal sides, whichever way the two run along it.
struct Gluing {
  std::vector<std::uint32_t> twin;                  ///< 3T: the other side, kNone at the boundary
  std::vector<std::uint32_t> edge_of;               ///< 3T, if asked for
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< E, lexicographic, if asked for
  std::size_t edge_count = 0;
};
/// Throws Reject: an index without node, a corner twice, three triangles at an edge, two with the
/// same corners. Cost: linear, plus the sorting of each node's edges.
Gluing glue(const Triangles& triangles, std::size_t nodes, bool with_edges);

/// What step 2 states, and whether the surface can be oriented.
struct SurfaceFacts {
  std::int64_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  bool orientable = true;
};
/// Throws Reject unless every vertex is in a face and its link is one cycle or one path.
SurfaceFacts check_surface(const Triangles& faces, const Gluing& gluing, std::size_t vertices);

/// Step 3. Node V + i is on edge line_edges[i], the node after those in face critical_faces[i].
struct Tiling {
  Triangles tiles;
  std::vector<std::uint32_t> line_edges, critical_faces;
};
Tiling tessellate(const ReebCertificate& c, const Gluing& mesh, SignLadder& sign);

/// Step 4. Returns the rank of every node. Throws Reject unless c.order is a permutation in which
/// successive nodes ascend by value, then number. `tiling` and `mesh` are read with degree 2 only.
std::vector<std::uint32_t> check_order(const ReebCertificate& c, const Gluing& mesh,
                                       const Tiling& tiling, Arithmetic arithmetic,
                                       SignCounts& counts);

/// K with the ranks of its nodes.
struct Complex {
  const Triangles& tiles;
  const std::vector<std::uint32_t>& twin;
  const std::vector<std::uint32_t>& rank;
  std::uint32_t node(std::uint32_t corner) const { return node_of(tiles, corner); }
  /// The ends of a side by rank.
  std::array<std::uint32_t, 2> ends(std::uint32_t side) const {
    const std::uint32_t a = node(side), b = node(next_corner(side));
    return rank[a] < rank[b] ? std::array{a, b} : std::array{b, a};
  }
  /// One number for both sides of an edge.
  std::uint32_t edge(std::uint32_t side) const { return side < twin[side] ? side : twin[side]; }
};

/// Calls visit(c) for every corner c of the node at `corner` until it returns true: first one way
/// round, then, if that ends at the boundary, the other.
template <class Visit>
void for_corners_around(const Complex& k, std::uint32_t corner, const Visit& visit) {
  const std::uint32_t v = k.node(corner);
  for (const bool way : {false, true}) {
    bool by_previous = way;
    std::uint32_t c = corner;
    do {
      if ((!way || c != corner) && visit(c)) return;
      const std::uint32_t across = k.twin[by_previous ? previous_corner(c) : c];
      if (across == kNone) break;
      by_previous = k.node(across) == v;
      c = by_previous ? across : next_corner(across);
    } while (c != corner);
    if (k.twin[by_previous ? previous_corner(c) : c] != kNone) return;
  }
}

/// Step 5: for every node one side to a lower and one to an upper node, kNone if there is none; for
/// every critical one sides that meet each of its runs (some twice).
struct NodeTypes {
  struct Node {
    std::uint32_t down = kNone, up = kNone;
    std::uint32_t transitions = 0;   ///< of its link, between lower and upper nodes
    std::uint32_t critical = kNone;  ///< position in critical_nodes, kNone if regular
  };
  std::vector<Node> nodes;                            ///< N
  std::vector<std::int32_t> index;                    ///< n
  std::vector<std::uint8_t> saddle;                   ///< n
  std::vector<std::uint32_t> start;                   ///< n + 1: into lower and upper
  std::vector<std::uint32_t> lower, upper;            ///< sides
  std::uint64_t minima = 0, saddles = 0, maxima = 0;  ///< saddles with multiplicity
  bool simple = true;                                 ///< no saddle of multiplicity above 1
};
NodeTypes check_types(const ReebCertificate& c, const Complex& k);

/// Step 6: the crossed edges of every cut.
struct Cuts {
  struct Crossing {
    std::uint32_t edge, cut;
  };
  std::vector<Crossing> crossings;    ///< by edge, then cut: upwards along the edge
  std::vector<std::uint8_t> crossed;  ///< 3T; empty without cuts
  std::vector<std::uint8_t> cycle;    ///< a cut: cycle or path
  std::vector<std::uint32_t> side;    ///< a cut: the side v w that names it
  /// The highest or the lowest cut across an edge, the next one on the edge v w of a cut; kNone if
  /// there is none.
  std::uint32_t highest(const Complex& k, std::uint32_t side) const;
  std::uint32_t lowest(const Complex& k, std::uint32_t side) const;
  std::uint32_t next_above(const Complex& k, std::uint32_t cut) const;
};
/// Throws Reject also for arcs or cuts that name nothing or are out of order.
Cuts check_cuts(const ReebCertificate& c, const Complex& k, const NodeTypes& types);

/// Step 7. Throws Reject unless theorem 6 applies and gives the stated graph.
void check_trees(const ReebCertificate& c, const Complex& k, const NodeTypes& types,
                 const Cuts& cuts);

}  // namespace crest::certify::reeb
