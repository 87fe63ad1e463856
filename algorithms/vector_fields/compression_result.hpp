// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What compress() returns: a field on fewer triangles with the same skeleton.
#include <string>

#include "algorithms/vector_fields/importance.hpp"

namespace crest::vector_fields {

/// What stays besides the starts, ends and orders of separatrices: all triangles that the skeleton
/// meets; those of zeros; their classes (paper 001, 5.3, 5.2, 5.4).
enum class Equivalence : std::uint8_t { strong, original, relaxed };
enum class CollapseTest : std::uint8_t { retrace, thesis };
/// Short edges first, small differences of vectors, or small products of both.
enum class CollapsePriority : std::uint8_t { length, error, product };

struct CompressionOptions {
  Equivalence equivalence = Equivalence::original;
  CollapseTest test = CollapseTest::retrace;
  CollapsePriority priority = CollapsePriority::product;
  bool boundary = true;  ///< collapses along the boundary, too
  /// Where nothing collapses any more, vertices are taken out with any other filling of their
  /// holes, and edges at inner vertices are flipped so that more of them can, by the same test. Not
  /// with the test as printed.
  bool flips = true;
  /// Zeros that weigh less may move, change and vanish in pairs, with the separatrices that start
  /// at them (section 5.5.4). Requires: Equivalence::original, the test retrace.
  std::optional<double> simplify = {};
  Laplacian laplacian = Laplacian::uniform;
};

/// Why collapses were refused.
struct RefusedCollapses {
  std::uint64_t geometry = 0, boundary = 0, critical_points = 0, ends = 0, order = 0, orbit = 0,
                undecided = 0;
};

struct CompressionCounts {
  int passes = 0;
  std::uint64_t collapses = 0, tests = 0, flips = 0, retraced_crossings = 0, inherited = 0;
  std::uint64_t filled = 0;  ///< of the collapses: vertices taken out with another filling
  RefusedCollapses refused;
  int rounds = 1;             ///< searches, until the proven skeletons were equal
  std::size_t pinned = 0;     ///< separatrices whose triangles were kept for that
  std::size_t undecided = 0;  ///< separatrices of the input without a proven end
  /// With `simplify`: zeros that vanished, and those left that are below the threshold.
  std::size_t cancelled = 0, left_below = 0;
};

struct Compression {
  PlanarField field;
  std::vector<Index> vertex_of;  ///< the vertices' numbers in the input, ascending
  Skeleton before, after;
  /// Proven but for the undecided separatrices; with `simplify` of the important part.
  bool same_skeleton = false;
  std::string difference;                ///< else the first one
  std::optional<Importance> importance;  ///< with `simplify`
  CompressionCounts counts;
};

}  // namespace crest::vector_fields
