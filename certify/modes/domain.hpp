// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The complex of the tetrahedra, zeros inserted (SPEC.md, H1 and H2).
#include <span>

#include "certify/modes/field.hpp"
#include "certify/modes/records.hpp"

namespace crest::certify::modes {

/// A face and the tetrahedra that have it; the second may be kNone.
struct DomainFace {
  std::array<u32, 3> corners;
  std::array<u32, 2> tets;
};

struct Domain {
  std::vector<std::array<u32, 4>> tets;  ///< corners ascending
  std::vector<DomainFace> faces;         ///< ascending

  /// Place among the faces, kNone if there is no such face.
  u32 find(const std::array<u32, 3>& corners) const;
  unsigned sides(u32 face) const { return faces[face].tets[1] == kNone ? 1 : 2; }
};

/// Adds the zeros to the field. Throws Reject.
Domain build_domain(const ModesCertificate& c, Field& field);

/// The corners that are not zero. Requires: none is of a split.
std::vector<u32> nonzero_corners(const Field& field, std::span<const u32> corners);

/// Whether the tensor is nonzero on the closed simplex of these corners. Cost: 0.1 ms or more.
bool zero_free(ExactTensors& exact, std::span<const u32> corners);

}  // namespace crest::certify::modes
