// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/degenerate_faces.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>

#include "kernel/geometry/mesh_piece.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

template <class F>
void in_parallel(std::size_t n, const F& f) {
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, n, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) f(i);
  });
}

std::vector<std::uint8_t> tets_without_degenerate(std::span<const TetCorners> tets,
                                                  std::span<const Tensor> tensors) {
  std::vector<Direction> u(tensors.size());
  in_parallel(u.size(), [&](std::size_t i) { u[i] = direction(tensors[i]); });
  std::vector<std::uint8_t> excluded(tets.size());
  in_parallel(tets.size(), [&](std::size_t t) {
    const TetCorners& c = tets[t];
    const std::array<Direction, 4> corners{u[c[0]], u[c[1]], u[c[2]], u[c[3]]};
    excluded[t] = cone_excludes(corners) ? 1 : 0;
  });
  return excluded;
}

/// Of the tetrahedra that are not excluded, ascending.
std::vector<FaceCorners> faces_of(std::span<const TetCorners> tets,
                                  const std::vector<std::uint8_t>& excluded) {
  std::vector<FaceCorners> faces;
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (std::size_t k = 0; k < 4 && excluded[t] == 0; ++k) faces.push_back(face_of(tets[t], k));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::vector<FaceRoots> roots_of(const std::vector<FaceCorners>& faces,
                                std::span<const Tensor> tensors) {
  std::vector<FaceRoots> roots(faces.size());
  in_parallel(faces.size(), [&](std::size_t i) {
    const FaceCorners& f = faces[i];
    roots[i] = face_roots({&tensors[f[0]], &tensors[f[1]], &tensors[f[2]]});
  });
  return roots;
}

using Owned = std::vector<std::vector<kernel::Index>>;  ///< tetrahedra by piece

FaceJob job_of(std::span<const TetCorners> tets, std::span<const Tensor> tensors,
               const std::vector<kernel::Index>& owned) {
  FaceJob r;
  std::vector<std::uint32_t> number(tensors.size(), kernel::kNone);
  for (const kernel::Index t : owned)
    for (const std::uint32_t v : tets[t]) number[v] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kernel::kNone) continue;
    number[v] = static_cast<std::uint32_t>(r.tensors.size());
    r.tensors.push_back(tensors[v]);
  }
  for (const kernel::Index t : owned) {
    const auto [a, b, c, d] = tets[t];
    r.tets.push_back({number[a], number[b], number[c], number[d]});
  }
  return r;
}

/// A piece's records to the faces they are of.
void put(std::span<const TetCorners> tets, const std::vector<kernel::Index>& owned,
         const FaceRecords& from, FaceTests& to) {
  std::vector<TetCorners> own;
  for (const kernel::Index t : owned) own.push_back(tets[t]);
  const std::vector<FaceCorners> faces = faces_of(own, from.excluded);
  std::size_t next = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto at = std::lower_bound(to.faces.begin(), to.faces.end(), faces[i]);
    FaceRoots& roots = to.roots[static_cast<std::size_t>(at - to.faces.begin())];
    roots = {};
    if (next < from.kept.size() && from.kept[next] == i) roots = from.roots[next++];
    roots.stage = from.stages[i];
  }
}

FaceTests join(std::span<const TetCorners> tets, const Owned& owned,
               const std::vector<FaceRecords>& parts) {
  FaceTests r;
  r.excluded.resize(tets.size());
  for (std::size_t p = 0; p < owned.size(); ++p)
    for (std::size_t i = 0; i < owned[p].size(); ++i)
      r.excluded[owned[p][i]] = parts[p].excluded[i];
  r.faces = faces_of(tets, r.excluded);
  r.roots.resize(r.faces.size());
  for (std::size_t p = 0; p < owned.size(); ++p) put(tets, owned[p], parts[p], r);
  return r;
}

}  // namespace

FaceCorners face_of(const TetCorners& tet, std::size_t k) {
  FaceCorners f{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
  std::sort(f.begin(), f.end());
  return f;
}

FaceRecords work_on(const FaceJob& job) {
  FaceRecords r;
  r.excluded = tets_without_degenerate(job.tets, job.tensors);
  const std::vector<FaceRoots> roots = roots_of(faces_of(job.tets, r.excluded), job.tensors);
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    r.stages.push_back(roots[i].stage);
    if (roots[i].count == 0 && !roots[i].special && !roots[i].multiple) continue;
    r.kept.push_back(i);
    r.roots.push_back(roots[i]);
  }
  return r;
}

FaceWorkers face_workers_here(kernel::Index pieces) {
  return {pieces, [](std::size_t jobs, const std::function<FaceJob(std::size_t)>& job) {
            std::vector<FaceRecords> r;
            for (std::size_t i = 0; i < jobs; ++i) r.push_back(work_on(job(i)));
            return r;
          }};
}

FaceTests test_faces(std::span<const kernel::Vec3> points, std::span<const TetCorners> tets,
                     std::span<const Tensor> tensors, const FaceWorkers* workers) {
  if (workers == nullptr || workers->pieces <= 1) {
    FaceTests r;
    r.excluded = tets_without_degenerate(tets, tensors);
    r.faces = faces_of(tets, r.excluded);
    r.roots = roots_of(r.faces, tensors);
    return r;
  }
  std::vector<kernel::Vec3> places;
  for (const TetCorners& tet : tets) places.push_back(points[tet[0]]);
  const Owned owned = kernel::cut_points(places, workers->pieces);
  return join(tets, owned, workers->tests(owned.size(), [&](std::size_t p) {
    return job_of(tets, tensors, owned[p]);
  }));
}

}  // namespace crest::modes
