// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The steps of claim 3 (SPEC.md, "What the checker proves, in order").
#include <array>
#include <cstdint>
#include <span>

#include "certify/exact/sign_ladder.hpp"
#include "certify/reeb/decode.hpp"
#include "certify/surface/gluing.hpp"

namespace crest::certify::reeb {

using u32 = std::uint32_t;
using Triangles = Buffer<Corners>;

/// What step 2 states, and whether the surface can be oriented.
struct SurfaceFacts {
  std::int64_t euler_characteristic = 0;
  u32 boundary_loops = 0, components = 0;
  bool orientable = true;
  Buffer<u32> corner;  ///< V: one of each vertex's corners
};
/// Throws Reject unless every vertex is in a face and its link is one cycle or one path.
SurfaceFacts check_surface(const Triangles& faces, const Gluing& gluing, std::size_t vertices);

/// Step 3. Node V + i is on edge line_edges[i], the node after those in face critical_faces[i]. The
/// tiles of a face follow one another. Degree 1: all empty, the tiles are the faces.
struct Tiling {
  Triangles tiles;
  Buffer<u32> first;      ///< F + 1: of each face's tiles
  Buffer<u32> line_node;  ///< E: the node of an edge, kNone without one
  Buffer<u32> line_edges, critical_faces;
};
Tiling tessellate(const ReebContents& c, const Gluing& mesh, SignLadder& sign);

/// What step 4 establishes.
struct NodeOrder {
  Buffer<u32> rank;           ///< N
  Buffer<std::uint8_t> tied;  ///< N: the node at a place has the value of the one before
};
/// Step 4. Throws Reject unless c.order is a permutation in which
/// successive nodes ascend by value, then number. `tiling` and `mesh` are read with degree 2 only.
NodeOrder check_order(const ReebContents& c, const Gluing& mesh, const Tiling& tiling,
                      Arithmetic arithmetic, SignCounts& counts);

/// K with the ranks of its nodes.
struct Complex {
  const Triangles& faces;
  const Gluing& mesh;
  const SurfaceFacts& surface;
  const Tiling& tiling;
  const Buffer<u32>& rank;

  bool divided() const { return !tiling.first.empty(); }
  const Triangles& tiles() const { return divided() ? tiling.tiles : faces; }
  std::size_t nodes() const { return rank.size(); }
  u32 line_node(u32 side) const { return divided() ? tiling.line_node[mesh.edge_of[side]] : kNone; }
};

/// Step 5: for every node a lower and an upper neighbour, kNone if there is none; for every
/// critical one neighbours in each of its runs (some twice).
struct NodeTypes {
  struct Node {
    u32 down, up;
    u32 transitions;  ///< of its link, between lower and upper nodes
    u32 ends;  ///< 0 in the interior, at the boundary 4 + the number of the link's lower ends
  };
  Buffer<Node> nodes;  ///< N
  Buffer<u32> start;   ///< N + 1: into lower and upper; nothing for a regular node
  Buffer<u32> lower, upper;
  std::uint64_t minima = 0, saddles = 0, maxima = 0;  ///< saddles with multiplicity
  bool simple = true;                                 ///< no saddle of multiplicity above 1

  bool critical(u32 v) const { return start[v] != start[v + 1]; }
};
/// Of a link; 0 of a kind at an extremum.
struct Runs {
  u32 lower, upper;
};
/// A cycle with t > 0 transitions has t / 2 runs of each kind, one with none a single run that is
/// all of it. A path has t + 1 runs; l - u is the number of its ends in lower runs, minus 1.
inline Runs runs_of(const NodeTypes::Node& node) {
  const u32 t = node.transitions;
  if (node.ends == 0) {
    if (t > 0) return {t / 2, t / 2};
    return node.down == kNone ? Runs{0, 1} : Runs{1, 0};
  }
  const u32 lower = (t + (node.ends & 3U)) / 2;
  return {lower, t + 1 - lower};
}

/// 1 - the Euler characteristic of the link's lower part.
inline std::int32_t index_of(const NodeTypes::Node& node) {
  const auto [l, u] = runs_of(node);
  return u == 0 && node.ends == 0 ? 1 : 1 - static_cast<std::int32_t>(l);
}

NodeTypes check_types(const ReebContents& c, const Complex& k);

/// Step 6: the edges of K that cuts cross.
struct Cuts {
  struct Crossing {
    u32 high, cut;
  };
  Buffer<u32> start;           ///< N + 1: into crossings, by the lower node; empty without cuts
  Buffer<Crossing> crossings;  ///< by lower node, upper node, cut: upwards along an edge
  Buffer<std::uint8_t> cycle;  ///< a cut: cycle or path

  bool near(u32 low) const { return !start.empty() && start[low] != start[low + 1]; }
  /// Those of one edge.
  std::span<const Crossing> across(u32 low, u32 high) const;
};
/// Throws Reject also for arcs or cuts that name nothing or are out of order.
Cuts check_cuts(const ReebContents& c, const Complex& k);

/// Arcs between nodes of equal value, the classes of nodes that they join, and how many of these
/// have one arc below and one above.
struct Contraction {
  u32 tied_arcs = 0, nodes = 0, passed = 0;
};
/// Step 8. Requires: the arcs name critical nodes (check_cuts), which ascend (check_types).
Contraction count_ties(const ReebContents& c, const NodeOrder& order);

/// Step 7. Throws Reject unless theorem 6 applies and gives the stated graph.
void check_trees(const ReebContents& c, const Complex& k, const NodeTypes& types, const Cuts& cuts);

}  // namespace crest::certify::reeb
