// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Curvatures piece by piece. A method is applied to a part of the mesh as to a mesh, and what the
// part owns is kept. One piece is the whole mesh, with nothing to leave out.
#include <functional>

#include "algorithms/curvature/methods.hpp"
#include "kernel/geometry/mesh_piece.hpp"

namespace crest::curvature {

/// In the order of the part's owned vertices, those left out excepted.
struct Records {
  std::vector<PointCurvature> vertices;
  std::vector<Vec3> normals;
  std::vector<VertexFlags> flags;
  std::vector<Index> left;  ///< places among the owned vertices: the rim is in their neighbourhood
};
/// options.normals are those of the part's vertices.
struct Job {
  kernel::MeshPart part;
  Options options;
};
Records work_on(const Job& job);

/// Who works on pieces, and on how many. Each job is asked for once; answers are in the jobs'
/// order.
struct Workers {
  Index pieces = 1;
  std::function<std::vector<Records>(std::size_t, const std::function<Job(std::size_t)>&)>
      estimates;
};
/// This process, one piece after the other.
Workers workers_here(Index pieces);

/// Of all vertices of a mesh, into storage that may be used again. Requires: checked input.
std::vector<VertexFlags> estimate_all(const kernel::TriangleMesh& mesh, const Options& options,
                                      Result& result);
/// The same of pieces.
std::vector<VertexFlags> estimate_pieces(const kernel::TriangleMesh& mesh, const Options& options,
                                         const Workers& workers, Result& result);

}  // namespace crest::curvature
