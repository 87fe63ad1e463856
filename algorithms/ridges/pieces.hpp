// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fits and exact decisions piece by piece: what is local of the graph. What is global (creases, the
// median of residuals, smoothing, chains, patches, salience) is made of the joined records.
//
//   fit_records of every piece, with as many rings as supports reach -> join -> FitResult
//   decide in every piece, with two rings and the forms in them      -> join -> Decisions -> graph
//
// One piece is the whole mesh: fit_monge_forms and extract_ridge_graph take the same way. So the
// result does not depend on how the mesh is cut.
#include <functional>

#include "algorithms/ridges/face_indices.hpp"
#include "kernel/geometry/mesh_piece.hpp"

namespace crest::ridges {

/// In the order of the piece's owned vertices, those left out excepted.
struct FitRecords {
  std::vector<kernel::MongeForm> forms;
  std::vector<FitQuality> quality;
  std::vector<CurvatureError> errors;  ///< of residuals of 1; none without FitOptions::errors
  std::vector<double> residuals;       ///< likewise
  /// Places among the owned vertices, ascending: supports that the rim has cut short.
  std::vector<Index> left;
};

/// Of the owned vertices. creases: of the piece's vertices (creases.hpp), or none.
FitRecords fit_records(const kernel::MeshPiece& piece, const std::vector<std::uint8_t>& creases,
                       const FitOptions& options);

/// What the exact rules say, element by element.
struct Decisions {
  EdgeStates states;
  FaceIndices indices;
  /// Vertices with n against the faces around them, with k1 = k2, with n x d1 = 0.
  Index against_faces = 0, equal_curvatures = 0, parallel_frames = 0;
};

/// Shapes: those of the piece's mesh. Requires: all corners of owned faces are inner.
Decisions decide(const kernel::MeshPiece& piece, const std::vector<kernel::MongeForm>& forms,
                 bool guarded);
/// Those of what the piece owns alone, in its order.
Decisions owned_of(const kernel::MeshPiece& piece, Decisions all);

/// What whoever works on a piece has to know.
struct FitJob {
  kernel::MeshPart part;
  std::vector<std::uint8_t> creases;
  FitOptions options;
};
struct DecisionJob {
  kernel::MeshPart part;
  std::vector<kernel::MongeForm> forms;
  bool guarded = true;
};
FitRecords work_on(const FitJob& job);
Decisions work_on(const DecisionJob& job);

/// Who works on pieces, and on how many. Each job is asked for once; answers are in the jobs'
/// order.
struct Workers {
  template <class Job, class Answer>
  using Call =
      std::function<std::vector<Answer>(std::size_t jobs, const std::function<Job(std::size_t)>&)>;

  Index pieces = 1;
  Call<FitJob, FitRecords> fit;
  Call<DecisionJob, Decisions> decide;
};
/// This process, one piece after the other.
Workers workers_here(Index pieces);

/// extract_ridge_graph from what is decided.
RidgeGraph graph_of(const kernel::TriangleMesh& mesh, const std::vector<kernel::MongeForm>& forms,
                    const GraphOptions& options, const Decisions& decided, PredicateReport* report);
/// By the workers; without them in this process, of the mesh as it is.
Decisions decide_all(const kernel::TriangleMesh& mesh, const std::vector<kernel::MongeForm>& forms,
                     bool guarded, const Workers* workers);
FitRecords fit_all(const kernel::TriangleMesh& mesh, const std::vector<std::uint8_t>& creases,
                   const FitOptions& options, const Workers* workers);

}  // namespace crest::ridges
