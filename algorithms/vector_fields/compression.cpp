// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/compression.hpp"

#include <algorithm>

#include "algorithms/vector_fields/collapser.hpp"
#include "algorithms/vector_fields/skeleton_match.hpp"

namespace crest::vector_fields {

namespace {

constexpr int kMostRounds = 20;

/// A half-edge of a triangle that is left, in the numbers of the output.
class HalfEdgeNumbers {
 public:
  explicit HalfEdgeNumbers(const CollapseMesh& mesh) : number_(mesh.triangle_count(), kNone) {
    Index count = 0;
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      if (mesh.alive(t)) number_[t] = count++;
  }
  HalfEdge operator()(HalfEdge h) const { return 3 * number_[h / 3] + h % 3; }

 private:
  std::vector<Index> number_;
};

/// The orbits' segments.
std::vector<AnnulusDoor> doors_of(const SearchState& state, const HalfEdgeNumbers& number) {
  std::vector<AnnulusDoor> doors;
  for (const SearchOrbit& o : state.orbits)
    if (!o.exits.empty())
      doors.push_back({o.forward, number(state.mesh.twin(o.exits.front())), 1 - o.high.front(),
                       1 - o.low.front()});
  return doors;
}

/// All, or what weighs as much as the threshold.
Kept kept_of(const Analysis& input, const Compression& result, const CompressionOptions& options) {
  Kept kept{std::vector<bool>(input.zeros.size(), true),
            std::vector<bool>(input.traces.size(), true)};
  if (!options.simplify) return kept;
  for (std::size_t z = 0; z < kept.zeros.size(); ++z)
    kept.zeros[z] = result.importance->zeros[z].weight >= *options.simplify;
  const auto& weights = result.importance->separatrices;
  for (std::size_t i = 0; i < weights.size(); ++i) kept.lines[i] = weights[i] >= *options.simplify;
  // Where something may vanish witnesses may not stand any more.
  std::fill(kept.lines.begin() + static_cast<std::ptrdiff_t>(weights.size()), kept.lines.end(),
            kept.all());
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
    const HalfEdgeNumbers number(state.mesh);
    std::vector<Witness> witnesses;
    if (kept.all())
      for (const Witness& w : input.witnesses)
        witnesses.push_back({number(state.mesh.leaving(input.domain.from(w.leaving))), w.forward});
    const Analysis output(result.field, doors_of(state, number), witnesses);
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
