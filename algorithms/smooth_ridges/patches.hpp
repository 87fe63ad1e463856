// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The faces of an umbilic's patch: a disk within the square of its blow-up
// (certify/ridges_smooth/SPEC.md, Patches 1; paper 002, section 6.3).
#include <vector>

#include "algorithms/smooth_ridges/face_test.hpp"
#include "algorithms/smooth_ridges/umbilics.hpp"

namespace crest::smooth_ridges {

struct PatchSearch {
  std::vector<Index> faces;      ///< ascending; a disk of faces, all within Q, or empty
  std::vector<Index> too_large;  ///< to be refined first
};

/// Whether the face, or one that bisection makes of it, may reach Q.
bool may_meet(const Surface& surface, const Triangulation& mesh, const Umbilic& umbilic,
              Index face);

/// `candidates`: all faces that may_meet(), ascending.
PatchSearch find_patch(const Surface& surface, const Triangulation& mesh, const Umbilic& umbilic,
                       const std::vector<Index>& candidates, FaceTest& test);

}  // namespace crest::smooth_ridges
