// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The complex of the tetrahedra, zeros inserted (SPEC.md, H1 and H2).
#include <span>

#include "certify/exact/tensor_field.hpp"
#include "certify/modes/records.hpp"
#include "certify/surface/tetrahedra.hpp"

namespace crest::certify::modes {

struct Domain {
  std::vector<std::array<u32, 4>> tets;  ///< corners ascending
  std::vector<TetFace> faces;            ///< ascending

  /// Place among the faces, kNone if there is no such face.
  u32 find(const std::array<u32, 3>& corners) const { return find_face(faces, corners); }
  unsigned sides(u32 face) const { return faces[face].tets[1] == kNone ? 1 : 2; }
};

/// Adds the zeros to the field. Throws Reject.
Domain build_domain(const ModesCertificate& c, Field& field);

/// Some corners of a tetrahedron, in their order.
struct Corners {
  std::array<u32, 4> list;
  std::size_t count = 0;

  std::size_t size() const { return count; }
  u32 operator[](std::size_t i) const { return list[i]; }
  const u32* begin() const { return list.data(); }
  const u32* end() const { return list.data() + count; }
};
/// The corners that are not zero. Requires: none is of a split.
Corners nonzero_corners(const Field& field, const std::array<u32, 4>& tet);

/// Whether the tensor is nonzero on the closed simplex of these corners. Cost: 0.1 ms or more.
bool zero_free(ExactTensors& exact, std::span<const u32> corners);

}  // namespace crest::certify::modes
