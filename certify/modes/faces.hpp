// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rejected simplices, witnesses, and the arcs of faces (SPEC.md, lemma 7).
#include <optional>
#include <span>

#include "certify/modes/edges.hpp"

namespace crest::certify::modes {

/// Throws Reject unless f has one sign on each closed simplex (zero counts as positive) and the
/// tensor is not zero where f >= 0.
void check_rejected(const LevelContext& context, std::span<const std::array<u32, 3>> simplices,
                    Worker& worker);
void check_rejected(const LevelContext& context, std::span<const std::array<u32, 4>> simplices,
                    Worker& worker);

/// A simplex and its witness; without lambda its form is D_w alone.
template <std::size_t n>
struct Witnessed {
  std::array<u32, n> corners;
  Direction<n> w;
  std::optional<double> lambda;
};
/// Throws Reject unless the witnesses' forms are strictly positive.
void check_witnesses(const LevelContext& context, std::span<const Witnessed<3>> simplices,
                     Worker& worker);
void check_witnesses(const LevelContext& context, std::span<const Witnessed<4>> simplices,
                     Worker& worker);

/// The arcs of a leaf with a witness that holds, ascending. Throws Reject if the enclosures of
/// roots do not tell.
std::vector<ArcPair> find_arcs(const LevelContext& context, const FaceNode& face, Worker& worker);

/// Of nodes first to end, decided leaves that are needed: rejected, or their witnesses hold and
/// their arcs are those listed.
void check_faces(const LevelContext& context, std::size_t first, std::size_t end, Worker& worker);

}  // namespace crest::certify::modes
