// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate points of all faces, piece by piece: which tetrahedra a cone excludes, and the points
// of the faces of the others. Both are functions of the corners' tensors alone: a piece needs no
// halo, and a face that two pieces have is solved by each, to the same bytes. Arcs are made of the
// joined records by whoever has the whole mesh.
#include <functional>
#include <span>
#include <vector>

#include "algorithms/modes/degenerate_face.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::modes {

struct FaceJob {
  std::vector<Tensor> tensors;   ///< a vertex of the piece, ascending as in the whole
  std::vector<TetCorners> tets;  ///< their corners, in the order of the whole mesh's
};

/// Of a job's tetrahedra and of the faces of those that are not excluded, the faces ascending.
struct FaceRecords {
  std::vector<std::uint8_t> excluded;  ///< a tetrahedron; 1: a cone excludes degenerate tensors
  std::vector<FaceStage> stages;       ///< a face
  std::vector<std::uint32_t> kept;     ///< places of the faces of which more is known: those with
  std::vector<FaceRoots> roots;        ///< points, special or with multiple points; their roots
};
FaceRecords work_on(const FaceJob& job);

/// Who tests pieces, and on how many. Each job is asked for once; answers are in the jobs' order.
struct FaceWorkers {
  kernel::Index pieces = 1;
  std::function<std::vector<FaceRecords>(std::size_t, const std::function<FaceJob(std::size_t)>&)>
      tests;
};
/// This process, one piece after the other.
FaceWorkers face_workers_here(kernel::Index pieces);

struct FaceTests {
  std::vector<std::uint8_t> excluded;  ///< a tetrahedron
  std::vector<FaceCorners> faces;      ///< of those that are not excluded, ascending
  std::vector<FaceRoots> roots;        ///< a face
};

/// By the workers; without them in this process, of the mesh as it is.
FaceTests test_faces(std::span<const kernel::Vec3> points, std::span<const TetCorners> tets,
                     std::span<const Tensor> tensors, const FaceWorkers* workers);

/// The face opposite corner k, ascending.
FaceCorners face_of(const TetCorners& tet, std::size_t k);

}  // namespace crest::modes
