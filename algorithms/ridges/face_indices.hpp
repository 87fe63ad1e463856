// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The umbilic index of every triangle: how often the maximal direction field turns around it
// (certify/ridges_mesh/SPEC.md, "Index of a face").
#include "algorithms/ridges/edge_states.hpp"

namespace crest::ridges {

/// Of a piece: counts and sum of what it owns; other faces are 0.
struct FaceIndices {
  std::vector<std::int8_t> twice;  ///< F: twice the index; odd exactly on conflict triangles
  int twice_sum = 0;               ///< on a closed mesh twice the Euler characteristic, identically
  StageCounts star_counts, rotation_counts;
};

FaceIndices face_indices(const kernel::MeshPiece& piece,
                         const std::vector<kernel::MongeForm>& forms, const EdgeStates& states);

}  // namespace crest::ridges
