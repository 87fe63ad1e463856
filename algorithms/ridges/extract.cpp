// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "algorithms/ridges/chains.hpp"
#include "algorithms/ridges/measures.hpp"
#include "algorithms/ridges/patch_joins.hpp"
#include "algorithms/ridges/pieces.hpp"
#include "algorithms/ridges/ridge_types.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "algorithms/ridges/umbilics.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

std::vector<PatchJoins> all_joins(const kernel::TriangleMesh& mesh,
                                  const std::vector<MongeForm>& forms, const EdgeStates& states,
                                  const UmbilicPatches& patches) {
  std::vector<PatchJoins> joins(patches.umbilics.size());
  const CrossingWeight weight = [&](Index e, Colour c) {
    return crossing_weight(mesh, forms, e, c);
  };
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, joins.size(), 64),
                       [&](const auto& range) {
                         for (std::size_t i = range.begin(); i != range.end(); ++i)
                           joins[i] = join_patch(mesh, states, patches.owner, patches.umbilics[i],
                                                 static_cast<Index>(i), weight);
                       });
  return joins;
}

Ridge realise(const Chain& chain, const kernel::TriangleMesh& mesh,
              const std::vector<MongeForm>& forms, const EdgeStates& states,
              const std::vector<PatchJoins>& joins, double size, TypeCounts& counts) {
  Ridge ridge;
  ridge.colour = chain.colour;
  ridge.loop = chain.loop;
  std::copy(chain.ends, chain.ends + 2, ridge.ends);
  ridge.crossings.reserve(chain.edges.size());
  for (Index e : chain.edges) {
    ridge.crossings.push_back(measure_crossing(mesh, forms, e, chain.colour));
    ridge.crossings.back().type = fourth_order_type(mesh, forms, e, chain.colour, counts);
  }
  ridge.third_order.reserve(ridge.segment_count());
  for (std::size_t i = 0; i < ridge.segment_count(); ++i)
    ridge.third_order.push_back(third_order_type(mesh, forms, states, chain.edges[i],
                                                 chain.edges[(i + 1) % chain.edges.size()],
                                                 chain.colour, counts));
  if (chain.ends[0].kind == EndKind::umbilic)
    ridge.lead_in = joins[chain.ends[0].umbilic].at(chain.edges.front(), chain.colour);
  if (chain.ends[1].kind == EndKind::umbilic) {
    ridge.lead_out = joins[chain.ends[1].umbilic].at(chain.edges.back(), chain.colour);
    std::reverse(ridge.lead_out.begin(), ridge.lead_out.end());
  }
  measure_ridge(ridge, size);
  return ridge;
}

}  // namespace

RidgeGraph graph_of(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                    const GraphOptions& options, const Decisions& decided,
                    PredicateReport* report) {
  const auto& [states, indices, against_faces, equal_curvatures, parallel_frames] = decided;
  UmbilicPatches patches = find_umbilics(mesh, forms, states, indices, options.umbilic_patch);

  RidgeGraph graph;
  graph.model_size = model_size(mesh);
  graph.ambiguous_edges = states.ambiguous_edges;
  graph.against_faces = against_faces;
  graph.equal_curvatures = equal_curvatures;
  graph.parallel_frames = parallel_frames;
  std::copy(states.zero_extremalities, states.zero_extremalities + 2, graph.zero_extremalities);
  graph.twice_index_sum = indices.twice_sum;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    graph.conflict_triangles += indices.twice[f] % 2 != 0;  // lemma 2; face_indices() makes sure
    if (indices.twice[f] != 0) graph.face_indices.push_back({f, indices.twice[f]});
  }
  const std::vector<PatchJoins> joins = all_joins(mesh, forms, states, patches);
  const std::vector<Chain> chains = chain_crossings(mesh, states, patches.owner);
  graph.ridges.resize(chains.size());
  tbb::enumerable_thread_specific<TypeCounts> counts_of_threads;
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, chains.size()), [&](const auto& range) {
    TypeCounts& counts = counts_of_threads.local();
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      graph.ridges[i] = realise(chains[i], mesh, forms, states, joins, graph.model_size, counts);
  });
  TypeCounts counts;
  for (const TypeCounts& c : counts_of_threads) {
    counts.crossing += c.crossing;
    counts.segment += c.segment;
  }
  graph.umbilics = std::move(patches.umbilics);
  if (report)
    *report = {
        {"acute_rule", states.acute_counts},   {"extremality_sign", states.extremality_counts},
        {"star_angles", indices.star_counts},  {"rotation", indices.rotation_counts},
        {"umbilic_kind", patches.kind_counts}, {"crossing_type", counts.crossing},
        {"segment_type", counts.segment}};
  return graph;
}

RidgeGraph extract_ridge_graph(const kernel::TriangleMesh& mesh,
                               const std::vector<MongeForm>& forms, const GraphOptions& options,
                               PredicateReport* report, const Workers* workers) {
  return graph_of(mesh, forms, options, decide_all(mesh, forms, options.guarded, workers), report);
}

Index open_ends(const RidgeGraph& graph) {
  Index count = 0;
  for (const Ridge& r : graph.ridges)
    if (!r.loop)
      for (const RidgeEnd& end : r.ends)
        count += end.kind == EndKind::none || end.kind == EndKind::cut;
  return count;
}

}  // namespace crest::ridges
