// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/ridges/chains.hpp"
#include "algorithms/ridges/measures.hpp"
#include "algorithms/ridges/patch_joins.hpp"
#include "algorithms/ridges/ridge_types.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "algorithms/ridges/umbilics.hpp"
#include "kernel/geometry/stop.hpp"
#include "kernel/predicates/against_faces.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

std::vector<PatchJoins> all_joins(const kernel::TriangleMesh& mesh,
                                  const std::vector<MongeForm>& forms, const EdgeStates& states,
                                  const UmbilicPatches& patches) {
  std::vector<PatchJoins> joins;
  for (Index i = 0; i < patches.umbilics.size(); ++i)
    joins.push_back(
        join_patch(mesh, states, patches.owner, patches.umbilics[i], i,
                   [&](Index e, Colour c) { return crossing_weight(mesh, forms, e, c); }));
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
    ridge.lead_in = joins[chain.ends[0].umbilic].at({chain.edges.front(), chain.colour});
  if (chain.ends[1].kind == EndKind::umbilic) {
    ridge.lead_out = joins[chain.ends[1].umbilic].at({chain.edges.back(), chain.colour});
    std::reverse(ridge.lead_out.begin(), ridge.lead_out.end());
  }
  measure_ridge(ridge, size);
  return ridge;
}

/// The three counts of frames that no surface has.
void count_frames(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                  RidgeGraph& graph) {
  std::vector<std::array<Vec3, 2>> sides;
  const auto count = [&](Index v) {
    const std::span<const Index> ring = mesh.ring(v);
    const std::size_t faces = ring.size() - (mesh.on_boundary(v) ? 1 : 0);
    sides.clear();
    for (std::size_t k = 0; k < faces; ++k)
      sides.push_back({mesh.points()[ring[k]], mesh.points()[ring[(k + 1) % ring.size()]]});
    graph.against_faces += kernel::against_faces(forms[v].n, mesh.points()[v], sides);
    graph.equal_curvatures += forms[v].k1 == forms[v].k2;
    graph.parallel_frames += kernel::collinear({0, 0, 0}, forms[v].n, forms[v].d1);
  };
  for (Index v = 0; v < mesh.vertex_count(); ++v) count(v);
}

}  // namespace

RidgeGraph extract_ridge_graph(const kernel::TriangleMesh& mesh,
                               const std::vector<MongeForm>& forms, const GraphOptions& options,
                               PredicateReport* report) {
  const EdgeStates states = edge_states(mesh, forms, options.guarded);
  const FaceIndices indices = face_indices(mesh, forms, states);
  UmbilicPatches patches = find_umbilics(mesh, forms, states, indices, options.umbilic_patch);

  RidgeGraph graph;
  graph.model_size = model_size(mesh);
  graph.ambiguous_edges = states.ambiguous_edges;
  count_frames(mesh, forms, graph);
  std::copy(states.zero_extremalities, states.zero_extremalities + 2, graph.zero_extremalities);
  graph.twice_index_sum = indices.twice_sum;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    graph.conflict_triangles += states.conflict(mesh, f);
    if (indices.twice[f] != 0) graph.face_indices.push_back({f, indices.twice[f]});
  }
  TypeCounts counts;
  const std::vector<PatchJoins> joins = all_joins(mesh, forms, states, patches);
  for (const Chain& chain : chain_crossings(mesh, states, patches.owner)) {
    kernel::stop_point();
    graph.ridges.push_back(realise(chain, mesh, forms, states, joins, graph.model_size, counts));
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

Index open_ends(const RidgeGraph& graph) {
  Index count = 0;
  for (const Ridge& r : graph.ridges)
    if (!r.loop)
      for (const RidgeEnd& end : r.ends)
        count += end.kind == EndKind::none || end.kind == EndKind::cut;
  return count;
}

}  // namespace crest::ridges
