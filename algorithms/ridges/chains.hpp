// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From crossed edges to loops and paths: the combinatorial ridge graph.
#include "algorithms/ridges/edge_states.hpp"

namespace crest::ridges {

/// A maximal chain of crossed edges of one colour; consecutive edges bound one triangle outside the
/// patches.
struct Chain {
  Colour colour;
  bool loop;
  RidgeEnd ends[2];
  std::vector<Index> edges;
};

/// The crossings on edges that are not inside a patch, chained; blue first, then by smallest edge.
/// Paths start at the end with the smaller edge, loops at their smallest edge towards the smaller
/// of its two neighbours. Requires: every conflict triangle has an owner.
std::vector<Chain> chain_crossings(const kernel::TriangleMesh& mesh, const EdgeStates& states,
                                   const std::vector<Index>& owner);

}  // namespace crest::ridges
