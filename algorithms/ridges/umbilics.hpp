// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Umbilic patches: disjoint disks of faces that hold every triangle of non-zero index. Coherent: of
// index +-1/2, its contour crossed by one ridge of each colour or by three of each.
#include "algorithms/ridges/face_indices.hpp"
#include "algorithms/ridges/patches.hpp"

namespace crest::ridges {

struct UmbilicPatches {
  std::vector<Umbilic> umbilics;  ///< by face
  std::vector<Index> owner;       ///< F: number of the umbilic whose patch holds the face, or kNone
  StageCounts kind_counts;
};

/// Around every triangle of non-zero index, in the order of k1 - k2 (mean of its corners, then face
/// number): the largest coherent patch met while it grows to the given size (index +-1/2, contour
/// crossed by one ridge of each colour or by three of each: section 6.3), else the triangle alone.
/// Patches do not overlap (hypothesis 2.2.a).
UmbilicPatches find_umbilics(const kernel::TriangleMesh& mesh,
                             const std::vector<kernel::MongeForm>& forms, const EdgeStates& states,
                             const FaceIndices& indices, double size);

}  // namespace crest::ridges
