// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which ridges of the graph are real, and which a person would draw: a filter on top of the graph,
// which stays as it is. Statistics, no proof.
//   Significant (level 1): runs of crossings (hysteresis.hpp) with significance z (prominence.hpp).
//   Salient (level 2): runs with crest_significance z, on the crest (k1 > |k2| or -k2 > |k1|),
//   whose weight W = integral of min(drop, 2 max|k|) ds (no unit) is at least min_weight. Umbilics:
//   umbilic_regions.hpp.
// At a crossing beside a vertex of a crease (creases.hpp) curvature has no bound: z and drop count
// as infinite. Of a run on the crest that is too light its piece of the crease, from the first such
// crossing to the last, is salient whatever its weight: between corners it may be a few edges long.
#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {

struct SalienceOptions {
  double z = 4;
  double min_weight = 1.5;
};

/// A component of doubtful and of umbilic faces (umbilic_regions.hpp).
struct UmbilicRegion {
  int twice_index = 0;
  int euler_characteristic = 0;
  Index faces = 0;
  std::vector<Index> umbilics;  ///< numbers in RidgeGraph::umbilics, ascending
  bool is_umbilic() const {
    return euler_characteristic == 1 && (twice_index == 1 || twice_index == -1);
  }
};

struct SalienceReport {
  Index significant = 0, salient = 0;  ///< ridges with a piece of that level; salient ones are both
  /// The ridges that are not salient: of no significant run, of short ones only; significant, but
  /// of no salient run, of light ones only.
  Index insignificant = 0, short_runs = 0, not_crest = 0, light = 0;
  double length = 0, length_significant = 0, length_salient = 0;  ///< between crossings
  double length_unweighted = 0;  ///< of the salient pieces whatever their weight
  Index gaps_closed = 0;
  Index undetermined = 0;  ///< crossings beside a vertex without a fit of degree 4: z = 0
  std::vector<UmbilicRegion> regions;
  /// Nothing is significant.
  bool degenerate() const { return significant == 0; }
};

/// Sets the salience of the graph's crossings, ridges and umbilics.
/// Requires: fit has errors and is that of the graph; z > 0. Guarantees: nothing else of the graph
///   changes; the same values whatever the thread count or the frames' signs.
SalienceReport mark_salience(const kernel::TriangleMesh& mesh, const FitResult& fit,
                             RidgeGraph& graph, const SalienceOptions& options = {});

}  // namespace crest::ridges
