// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Steps 1 and 2: the data's requirements, edges, rings, Euler characteristic, boundary loops.
#include <cstdint>
#include <vector>

#include "certify/certificate.hpp"
#include "certify/exact/sign_ladder.hpp"

namespace crest::certify {

inline constexpr std::uint32_t kNone = 0xffffffffU;

/// Corner c = 3 f + i is corner i of face f; side c runs from corner i to the next one, and is
/// across from the corner before. All arrays are plain: E edges, F faces, V vertices.
constexpr std::uint32_t next_corner(std::uint32_t c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
constexpr std::uint32_t previous_corner(std::uint32_t c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}

struct Edge {
  std::uint32_t low, high;          ///< vertices, low < high
  std::uint32_t forward, backward;  ///< the sides low -> high and high -> low, or kNone
};

struct Topology {
  std::vector<Edge> edges;                   ///< E, lexicographic
  std::vector<std::uint32_t> edge_of;        ///< 3F: the edge of a side
  std::vector<std::uint32_t> twin;           ///< 3F: the side of the same edge in the other face
  std::vector<std::uint32_t> ring_start;     ///< V + 1
  std::vector<std::uint32_t> ring;           ///< 3F: corners around each vertex from w_0 on
  std::vector<std::uint32_t> ring_position;  ///< 3F: the corner's place in its ring
  std::vector<std::uint8_t> on_boundary;     ///< V
  std::int64_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0;
};

/// Throws Reject if the faces are not an oriented manifold (certify/SPEC.md, requirements).
/// Cost: linear, plus the sorting of each vertex's edges.
Topology build_topology(const MeshData& data);

/// Throws Reject for a face of zero area, zero d1 or n, k1 < k2.
void check_geometry(const MeshData& data, SignLadder& sign);

inline std::uint32_t vertex_of(const MeshData& data, std::uint32_t corner) {
  return data.faces[corner / 3][corner % 3];
}

}  // namespace crest::certify
