// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All faces and edges (SPEC.md, theorem 9).
#include "certify/ridges_smooth/provers.hpp"

namespace crest::certify::smooth {

/// Bits: edges of the face, edge i from corner i to the next.
struct FaceResult {
  std::optional<std::array<kernel::Range, 3>> box;  ///< kind 0: of the image, if found
  std::array<std::uint8_t, 2> crossed{};            ///< of colours with a direction c
  std::array<std::uint8_t, 2> decided{};
  /// Of E_j along the edges that are decided by it.
  std::array<std::array<kernel::MaybeSign, 3>, 2> slope{};
  std::array<std::uint8_t, 2> loose{};  ///< bits: corners of the domain, their sign taken positive
};

/// Chart conditions of all faces; outside patches (R), verdicts, signs at corners, types, purple
/// points. Throws Reject, of the least face.
std::vector<FaceResult> check_faces(const Claim& claim);

/// Part of check_faces: loose corners of several faces (SPEC.md, "Loose corners"). Throws Reject or
/// Undecided.
void check_undrawn_arcs(const Claim& claim);

/// Every edge that is not interior to a patch: by colour, is it crossed? Throws Reject: an edge
/// that no face decides, or one between a patch and another patch or the boundary.
std::array<std::vector<std::uint8_t>, 2> check_edges(const Claim& claim,
                                                     const std::vector<FaceResult>& faces);

}  // namespace crest::certify::smooth
