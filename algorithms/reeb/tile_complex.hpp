// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tessellation of every quadratic face into monotone tiles (paper 003, sections 3 and 4), as
// certify/reeb/SPEC.md defines it: nodes, tiles, and the total order of the nodes.
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/geometry/quadratic_mesh.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::reeb {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;

/// Nodes: V mesh vertices, then the line-critical points by edge, then the face-critical points by
/// their face's sorted corners. Tiles are triangles of nodes, those of face f being
/// tiles[tile_begin[f]] .. tiles[tile_begin[f + 1]] (tile_begin is empty for a linear function:
/// the tiles are the faces), each ordered as its face is.
struct TileComplex {
  Index vertex_count = 0;             ///< V of the mesh
  std::vector<Index> critical_edges;  ///< ascending edges; node V + i lies on critical_edges[i]
  std::vector<Index> critical_faces;  ///< node V + critical_edges.size() + i lies in this face
  std::vector<Triangle> tiles;
  std::vector<Index> tile_begin;
  std::vector<Index> order;  ///< nodes by ascending value, equal values by number
  std::vector<Index> rank;   ///< its inverse
  /// Rank r has the same value as rank r - 1: a tie that the numbers decided. Bytes 0 or 1.
  std::vector<std::uint8_t> tied;

  Index node_count() const { return static_cast<Index>(rank.size()); }
};

/// Who decided, a line for each named predicate.
using PredicateReport = std::vector<std::pair<std::string, kernel::StageCounts>>;

/// Guarantees: exact for every input; the same for any thread count, and up to the numbering of
///   faces and tiles independent of the order of the faces and of their corners.
/// Cost: O(n log n) for n nodes. `guarded` = false decides in plain double (for measuring only).
TileComplex tessellate(const kernel::QuadraticMesh& mesh, PredicateReport* report = nullptr,
                       bool guarded = true);

/// Where a node lies and its value, to a few units in the last place (exact at mesh vertices); the
/// values never descend along the order. Independent of the order of faces and corners.
struct NodePlace {
  kernel::Vec3 point;
  double value;
};
std::vector<NodePlace> node_places(const kernel::QuadraticMesh& mesh, const TileComplex& tiles);

}  // namespace crest::reeb
