// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/compression.hpp"

#include <algorithm>

#include "algorithms/vector_fields/collapser.hpp"
#include "algorithms/vector_fields/skeleton_match.hpp"

namespace crest::vector_fields {

namespace {

constexpr int kMostRounds = 20;

/// The orbits' segments in the numbers of the output.
std::vector<AnnulusDoor> doors_of(const SearchState& state) {
  std::vector<Index> number(state.mesh.triangle_count(), kNone);
  Index count = 0;
  for (Index t = 0; t < state.mesh.triangle_count(); ++t)
    if (state.mesh.alive(t)) number[t] = count++;
  std::vector<AnnulusDoor> doors;
  for (const SearchOrbit& o : state.orbits) {
    if (o.exits.empty()) continue;
    const HalfEdge side = state.mesh.twin(o.exits.front());
    doors.push_back(
        {o.forward, 3 * number[side / 3] + side % 3, 1 - o.high.front(), 1 - o.low.front()});
  }
  return doors;
}

/// All, or what weighs as much as the threshold.
Kept kept_of(const Analysis& input, const Compression& result, const CompressionOptions& options) {
  Kept kept{std::vector<bool>(input.zeros.size(), true),
            std::vector<bool>(input.traces.size(), true)};
  if (!options.simplify) return kept;
  for (std::size_t z = 0; z < kept.zeros.size(); ++z)
    kept.zeros[z] = result.importance->zeros[z].weight >= *options.simplify;
  for (std::size_t i = 0; i < kept.lines.size(); ++i)
    kept.lines[i] = result.importance->separatrices[i] >= *options.simplify;
  return kept;
}

}  // namespace

Compression compress(const PlanarField& field, const CompressionOptions& options) {
  return compress(field, options, [](const Analysis&, const Analysis&, const SkeletonMatch&) {});
}

Compression compress(const PlanarField& field, const CompressionOptions& options,
                     const SkeletonProof& proof) {
  const Analysis input(field);
  Compression result;
  result.before = input.skeleton();
  if (options.simplify)
    result.importance = weigh(field, smoothed(field, options.laplacian), result.before);
  const Kept kept = kept_of(input, result, options);
  const auto important =
      static_cast<std::size_t>(std::count(kept.zeros.begin(), kept.zeros.end(), true));
  std::vector<bool> pinned(input.traces.size(), false);
  for (int round = 1; round <= kMostRounds; ++round) {
    SearchState state(input, pinned, kept);
    CompressionCounts counts;
    Collapser(state, options).run(counts);
    counts.rounds = round;
    counts.pinned = static_cast<std::size_t>(std::count(pinned.begin(), pinned.end(), true));
    result.field = state.mesh.field(result.vertex_of);
    const Analysis output(result.field, doors_of(state));
    const SkeletonMatch match = match_skeletons(input, output, state, kept);
    counts.inherited += match.inherited;
    counts.left_below = output.zeros.size() - std::min(important, output.zeros.size());
    counts.cancelled = input.zeros.size() - std::min(output.zeros.size(), input.zeros.size());
    result.counts = counts;
    result.after = output.skeleton();
    result.same_skeleton = match.same;
    result.difference = match.difference;
    if (match.same) {
      proof(input, output, match);
      break;
    }
    bool more = false;
    for (const Index i : match.differing) {
      more = more || !pinned[i];
      pinned[i] = true;
    }
    if (!more) break;
  }
  result.counts.undecided = static_cast<std::size_t>(
      std::count_if(input.traces.begin(), input.traces.end(),
                    [](const Trace& t) { return t.end == EndKind::undecided; }));
  return result;
}

}  // namespace crest::vector_fields
