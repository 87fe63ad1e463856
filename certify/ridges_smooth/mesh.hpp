// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Step 2 of claim 4: the complex |T|, its components, the patches as disks; and the chart
// conditions of kind 1, which are exact (SPEC.md, "Triangulation").
#include <cmath>

#include "certify/exact/sign_ladder.hpp"
#include "certify/ridges_smooth/records.hpp"
#include "certify/surface/mesh_checks.hpp"

namespace crest::certify::smooth {

struct Mesh {
  Topology topology;
  std::vector<std::uint32_t> component;  ///< F: numbered by their first faces
  std::uint32_t components = 0;
  std::vector<std::uint32_t> patch_of;  ///< F: kNone outside
};

/// Throws Reject: no oriented manifold; boundary where none may be; patches that are not disjoint
/// disks in ascending order, or not those that the face records mark.
Mesh check_mesh(const RidgesSmoothCertificate& c);

/// Kind 0: h = 2^(k0 - c) of a face; 0 for a witness without c.
inline double fibre_length(const RidgesSmoothCertificate& c, std::uint32_t face) {
  const Bytes& witness = c.face_records[face].witness;
  return witness.empty() ? 0 : std::ldexp(1.0, c.reach - int{witness[0]});
}

/// Of the square.
inline bool is_corner(const std::array<double, 6>& vertex) {
  return (vertex[0] == 0 || vertex[0] == 1) && (vertex[1] == 0 || vertex[1] == 1);
}
/// Of a corner of the square in loose_corners, for colour j.
inline std::size_t loose_bit(const std::array<double, 6>& corner, std::size_t j) {
  return 4 * j + (corner[0] == 1 ? 1 : 0) + (corner[1] == 1 ? 2 : 0);
}

/// Bit i of U (V: bit 3 + i) of face f; zero without lifts.
inline int lift_of(const RidgesSmoothCertificate& c, std::uint32_t f, std::size_t corner,
                   std::size_t direction) {
  return c.lifts.empty() ? 0 : c.lifts[f] >> (3 * direction + corner) & 1;
}

/// Kind 1: positive areas that sum to 1, consistent lifts, boundary on the sides of the square.
/// Throws Reject.
void check_unit_square(const RidgesSmoothCertificate& c, const Mesh& mesh, SignLadder& sign);

}  // namespace crest::certify::smooth
