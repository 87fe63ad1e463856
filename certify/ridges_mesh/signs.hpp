// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The signs of SPEC.md, "Definitions": acute rule, extremalities, crossings, types, kind.
#include <cstdint>
#include <vector>

#include "certify/exact/sign_ladder.hpp"
#include "certify/ridges_mesh/records.hpp"
#include "certify/surface/mesh_checks.hpp"

namespace crest::certify {

enum Colour : std::size_t { blue = 0, red = 1 };

/// Step 3. Crossings are bits: 1 blue, 2 red.
struct MeshSigns {
  std::vector<std::int8_t> acute;                       ///< E: s
  std::array<std::vector<std::int8_t>, 2> extremality;  ///< V: beta0, beta3
  std::vector<std::uint8_t> crossings;                  ///< E
  std::vector<std::uint8_t> conflict;                   ///< F: the product of s is negative
  std::uint32_t ambiguous_edges = 0, conflict_triangles = 0;
  std::array<std::uint32_t, 2> zero_extremalities{};

  bool crossed(std::uint32_t edge, Colour colour) const {
    return (crossings[edge] >> colour & 1U) != 0;
  }
};
MeshSigns decide_signs(const MeshData& data, const Topology& topology, SignLadder& sign);

/// Fourth-order type of a crossing: 1 elliptic, 2 hyperbolic, 0 flat.
unsigned crossing_type(const MeshData& data, const Edge& edge, Colour colour, SignLadder& sign);

/// Third-order type of a segment: 1 elliptic, 2 hyperbolic, 0 undecided. `corner` is the corner
/// between the two crossed sides.
unsigned segment_type(const MeshData& data, const MeshSigns& signs, std::uint32_t corner,
                      Colour colour, SignLadder& sign);

/// The corner of a face with the least k1 - k2; ties: the first.
std::uint32_t least_gap_corner(const MeshData& data, std::uint32_t face, SignLadder& sign);
/// Is k1 - k2 less at p than at q?
bool less_gap(const MeshData& data, std::uint32_t p, std::uint32_t q, SignLadder& sign);

/// 1 for a 1-ridge, 3 for a 3-ridge umbilic, 0 degenerate.
unsigned umbilic_kind(const MeshData& data, std::uint32_t face, SignLadder& sign);

}  // namespace crest::certify
