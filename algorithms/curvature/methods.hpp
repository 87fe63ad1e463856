// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The methods behind estimate(): each fills one entry a vertex. Requires checked input.
#include <tbb/blocked_range.h>

#include <vector>

#include "algorithms/curvature/curvature.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::curvature {

/// What is to be counted about a vertex.
struct VertexFlags {
  bool lowered = false, complex = false, undetermined = false;
};

/// area_weighted_normals() into storage of the right size.
void area_weighted_normals(const kernel::TriangleMesh& mesh, std::vector<Vec3>& normals);

/// np, ne: mean of the corner tensors over the fan.
void normal_based(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                  std::vector<PointCurvature>& out, std::vector<VertexFlags>& flags);

/// cf, qf, qt, jet.
void fit(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, const Options& options,
         std::vector<PointCurvature>& out, std::vector<VertexFlags>& flags);

void normal_cycle(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, int rings,
                  std::vector<PointCurvature>& out, std::vector<VertexFlags>& flags);

/// v, then its neighbours ring by ring, whole rings: `rings` of them, and more until there are
/// `points` neighbours or no more to find. Sorted within a ring.
void collect_rings(const kernel::TriangleMesh& mesh, Index v, int rings, std::size_t points,
                   std::vector<Index>& out);

/// body(i) for i in [0, n) in parallel; each i writes only what is its own.
template <class Body>
void for_each_index(Index n, Body&& body) {
  kernel::parallel_for(tbb::blocked_range<Index>(0, n, 512), [&](const auto& range) {
    for (Index i = range.begin(); i != range.end(); ++i) {
      if (i % 64 == 0) kernel::stop_point();  // TBB's parts may be long
      body(i);
    }
  });
}

}  // namespace crest::curvature
