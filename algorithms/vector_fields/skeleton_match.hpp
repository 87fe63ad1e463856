// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Compares two proven skeletons: of a field, and of the same field on fewer triangles.
#include <functional>
#include <string>

#include "algorithms/vector_fields/analysis.hpp"
#include "algorithms/vector_fields/search.hpp"

namespace crest::vector_fields {

struct SkeletonMatch {
  bool same = false;
  std::string difference;  ///< the first
  /// For each of the input the number of the output's.
  std::vector<Index> zeros, orbits, separatrices;
  std::vector<Index> differing;  ///< separatrices of the input
  std::size_t inherited = 0;     ///< pairs whose order is that of where they came together
};

/// found: how the output's zeros, boundary and saddles' rays are named. Of what is not kept nothing
/// is compared, its numbers are kNone.
SkeletonMatch match_skeletons(const Analysis& input, const Analysis& output,
                              const SearchState& found, const Kept& kept);

/// What is done with two skeletons that are the same.
using SkeletonProof =
    std::function<void(const Analysis& input, const Analysis& output, const SkeletonMatch&)>;

/// compress() of compression.hpp.
Compression compress(const PlanarField& field, const CompressionOptions& options,
                     const SkeletonProof& proof);

}  // namespace crest::vector_fields
