// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The support chosen from the mesh itself. Supports of 30 * 1.5^i points are tried, by rings, so
// that they follow the local density:  J = S^2 / L,  S the length of the salient pieces before a
// weight is asked for, L the length of the whole graph. If no support has a salient piece S is the
// length of all significant ones, as far as the support before or the one after has as much: what a
// single support shows is that support's. Two decreases of J in a row end the search. Taken is the
// smallest support where the mean of J over it, twice, and its neighbours is 97 % of the largest:
// noise of another seed moves a single J by some 10 % and would change the support. Where nothing
// is significant it is 30 points.
#include "algorithms/ridges/salience.hpp"

namespace crest::ridges {

struct SupportTrial {
  int points;
  double length, salient_length, significant_length, j;
};

struct SupportChoice {
  int points = 30;
  std::vector<SupportTrial> trials;  ///< in the order tried; J of each itself
};

/// Requires: nothing of options but degree and smooth matters. Guarantees: the same for any number
/// of threads and pieces. Cost: of seven fits and extractions, the last of them 340 points, at
/// most.
SupportChoice choose_support(const kernel::TriangleMesh& mesh, const FitOptions& options,
                             const GraphOptions& graph_options = {},
                             const SalienceOptions& salience = {},
                             const Workers* workers = nullptr);

}  // namespace crest::ridges
