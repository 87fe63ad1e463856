// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rejected simplices, witnesses, and the arcs of faces (SPEC.md, lemma 7).
#include <optional>

#include "certify/modes/edges.hpp"

namespace crest::certify::modes {

/// Throws Reject unless f has one sign on the closed simplex (zero counts as positive) and the
/// tensor is not zero where f >= 0.
void check_rejected(const LevelContext& context, const std::array<u32, 2>& corners, Worker& worker);
void check_rejected(const LevelContext& context, const std::array<u32, 3>& corners, Worker& worker);
void check_rejected(const LevelContext& context, const std::array<u32, 4>& corners, Worker& worker);

/// Throws Reject unless the witness' form is strictly positive; without lambda it is D_w alone.
void check_witness(const LevelContext& context, const std::array<u32, 3>& corners,
                   const Direction<3>& w, std::optional<double> lambda, Worker& worker);
void check_witness(const LevelContext& context, const std::array<u32, 4>& corners,
                   const Direction<4>& w, std::optional<double> lambda, Worker& worker);

/// The arcs of a leaf with a witness that holds, ascending. Throws Reject if the enclosures of
/// roots do not tell.
std::vector<ArcPair> find_arcs(const LevelContext& context, const FaceNode& face, Worker& worker);

/// A leaf: rejected, or its witness holds and its arcs are those listed.
void check_face(const LevelContext& context, u32 node, Worker& worker);

}  // namespace crest::certify::modes
