// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An oriented manifold: edges, rings, Euler characteristic, boundary loops. All arrays are plain: E
// edges, F faces, V vertices.
#include <vector>

#include "certify/surface/gluing.hpp"

namespace crest::certify {

struct Edge {
  std::uint32_t low, high;          ///< vertices, low < high
  std::uint32_t forward, backward;  ///< the sides low -> high and high -> low, or kNone
};

struct Topology {
  std::vector<Edge> edges;                   ///< E, lexicographic
  Buffer<std::uint32_t> edge_of;             ///< 3F: the edge of a side
  Buffer<std::uint32_t> twin;                ///< 3F: the side of the same edge in the other face
  std::vector<std::uint32_t> ring_start;     ///< V + 1
  std::vector<std::uint32_t> ring;           ///< 3F: corners around each vertex from w_0 on
  std::vector<std::uint32_t> ring_position;  ///< 3F: the corner's place in its ring
  std::vector<std::uint8_t> on_boundary;     ///< V
  std::int64_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0;
};

/// Throws Reject if the faces are not an oriented manifold (ridges_mesh/SPEC.md, requirements).
/// Cost: linear, plus the sorting of each vertex's edges.
Topology build_topology(Faces faces, std::size_t vertices);

}  // namespace crest::certify
