// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/curvature/pieces.hpp"

#include <algorithm>

namespace crest::curvature {
namespace {

using kernel::MeshPiece;
using kernel::TriangleMesh;

/// What the methods look at: normals of neighbours, dihedral angles of a region's edges; of jet's
/// rings a guess.
Index rings_of(const Options& options) {
  constexpr Index kJetRings = 5;
  if (options.method == Method::jet) return kJetRings;
  const bool cycle = options.method == Method::normal_cycle;
  return 2 + (cycle ? static_cast<Index>(options.rings) : 0);
}

/// Whether the vertex's neighbourhood may be another than in the whole mesh.
bool is_left(const MeshPiece& piece, Index v, const Options& options, std::vector<Index>& found) {
  if (options.method != Method::jet) return false;
  collect_rings(piece.mesh(), v, 1, static_cast<std::size_t>(options.jet_points), found);
  return !std::all_of(found.begin(), found.end(), [&](Index w) { return piece.is_inner(w); });
}

Job job_of(const TriangleMesh& mesh, const std::vector<Index>& owned, Index rings,
           const Options& options) {
  Job r{kernel::mesh_part(mesh, owned, rings), options};
  r.options.normals.clear();
  if (!options.normals.empty())
    for (const Index v : r.part.vertices) r.options.normals.push_back(options.normals[v]);
  return r;
}

}  // namespace

Records work_on(const Job& job) {
  const TriangleMesh mesh(job.part.points, job.part.faces);
  const MeshPiece piece(mesh, job.part);
  Result all;
  const std::vector<VertexFlags> flags = estimate_all(mesh, job.options, all);
  const std::vector<Index> owned = piece.owned_vertices();
  std::vector<Index> found;
  Records r;
  for (Index i = 0; i < owned.size(); ++i) {
    const Index v = owned[i];
    if (is_left(piece, v, job.options, found)) {
      r.left.push_back(i);
      continue;
    }
    r.vertices.push_back(all.vertices[v]);
    r.normals.push_back(all.normals[v]);
    r.flags.push_back(flags[v]);
  }
  return r;
}

Workers workers_here(Index pieces) {
  return {pieces, [](std::size_t jobs, const std::function<Job(std::size_t)>& job) {
            std::vector<Records> r;
            for (std::size_t i = 0; i < jobs; ++i) r.push_back(work_on(job(i)));
            return r;
          }};
}

std::vector<VertexFlags> estimate_pieces(const TriangleMesh& mesh, const Options& options,
                                         const Workers& workers, Result& result) {
  std::vector<VertexFlags> flags(mesh.vertex_count());
  result.vertices.resize(mesh.vertex_count());
  result.normals.resize(mesh.vertex_count());
  auto owned = kernel::cut_points(mesh.points(), workers.pieces);
  for (Index rings = rings_of(options); !owned.empty(); rings *= 2) {
    const auto found = workers.estimates(
        owned.size(), [&](std::size_t p) { return job_of(mesh, owned[p], rings, options); });
    for (std::size_t p = 0; p < owned.size(); ++p) {
      std::size_t i = 0;
      for (const Index v : kernel::take_done(owned[p], found[p].left)) {
        result.vertices[v] = found[p].vertices[i];
        result.normals[v] = found[p].normals[i];
        flags[v] = found[p].flags[i++];
      }
    }
    std::erase_if(owned, [](const auto& left) { return left.empty(); });
  }
  return flags;
}

}  // namespace crest::curvature
