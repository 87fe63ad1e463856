// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Feature lines of a triangle mesh from a number a vertex (paper 001, section 3.4): the public
// call. Theory and limits: README.md beside this file.
#include <optional>

#include "algorithms/feature_lines/feature_graph.hpp"
#include "algorithms/feature_lines/skeleton.hpp"

namespace crest::feature_lines {

struct Options {
  double quantile = 0.85;       ///< of the field, used without `value` (quantile_threshold)
  bool seek_gap = false;        ///< the quantile is a guess (gap_threshold)
  std::optional<double> value;  ///< vertices with field >= value are marked
  Neighbourhood neighbourhood = Neighbourhood::rings;
  /// Sizes of the structure element (see Structure), applied in this order; 0: not applied.
  double dilate = 0, erode = 0, open = 0, close = 0;
  Index prune = 0;           ///< branches of at most so many vertices vanish
  Index min_patch = 0;       ///< smaller patches are filled and the region thinned again
  Index close_branches = 0;  ///< longest gap closed between two open ends, in edges
};

/// One thinning: what a certificate speaks about.
struct Thinning {
  Marks before, after;         ///< V
  std::vector<Index> removed;  ///< before \ after, in an order of simple removals
  std::vector<Index> dropped;  ///< isolated vertices of `after` that the result leaves out
  Topology topology_before, topology_after;  ///< equal
};

struct FeatureLines {
  double value = 0;          ///< the threshold used
  Marks marks;               ///< V: the result, `thinning.after` without `dropped`
  Thinning thinning;         ///< the last one: after filling and closing, if there was any
  FeatureGraph graph;        ///< of `marks`
  Index marked = 0;          ///< vertices in the feature region before thinning
  Index filled_patches = 0;  ///< patches filled because of min_patch
  Index joined = 0;          ///< pairs of open ends joined
  Index thinnings = 0;       ///< how often the region was thinned; `thinning` is the last one
};

/// Thins the region to lines: skeletonize, pre_prune, prune; along the field's crests, if given.
/// Guarantees: after has the topology of before; no simple vertex of `after` has two or more
///   marked neighbours.
Thinning thin(const kernel::TriangleMesh& mesh, Marks region, Index prune,
              const std::vector<double>& field = {});

/// Shapes: one field value a vertex. Deterministic; no threads.
/// Throws: InputError for another number of values, a value that is not a number, or coordinates
///   out of range (kernel::require_carried).
/// Cost: O(V) besides the operators; about 0.3 microseconds a vertex.
FeatureLines extract_feature_lines(const kernel::TriangleMesh& mesh,
                                   const std::vector<double>& field, const Options& options);

}  // namespace crest::feature_lines
