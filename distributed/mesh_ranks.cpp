// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/curvature/pieces.hpp"
#include "algorithms/modes/pieces.hpp"
#include "algorithms/ridges/pieces.hpp"
#include "cli/mesh_workers.hpp"
#include "distributed/messages.hpp"
#include "distributed/systems.hpp"

namespace crest::distributed {

// What a message consists of, in one place for both ways.
template <class Use>
void for_members(kernel::MeshPart& part, const Use& use) {
  use(part.points);
  use(part.faces);
  use(part.roles);
  use(part.vertices);
}
template <class Use>
void for_members(curvature::Job& job, const Use& use) {
  for_members(job.part, use);
  use(job.options.method);
  use(job.options.normals);
  use(job.options.degree);
  use(job.options.jet_points);
  use(job.options.rings);
}
template <class Use>
void for_members(curvature::Records& records, const Use& use) {
  use(records.vertices);
  use(records.normals);
  use(records.flags);
  use(records.left);
}
template <class Use>
void for_members(ridges::FitJob& job, const Use& use) {
  for_members(job.part, use);
  use(job.creases);
  use(job.options);
}
template <class Use>
void for_members(ridges::FitRecords& records, const Use& use) {
  use(records.forms);
  use(records.quality);
  use(records.errors);
  use(records.residuals);
  use(records.left);
}
template <class Use>
void for_members(ridges::DecisionJob& job, const Use& use) {
  for_members(job.part, use);
  use(job.forms);
  use(job.guarded);
}
template <class Use>
void for_members(ridges::Decisions& d, const Use& use) {
  use(d.states.acute);
  use(d.states.crossed);
  for (auto& signs : d.states.extremality) use(signs);
  use(d.states.ambiguous_edges);
  for (auto& count : d.states.zero_extremalities) use(count);
  use(d.states.acute_counts);
  use(d.states.extremality_counts);
  use(d.indices.twice);
  use(d.indices.twice_sum);
  use(d.indices.star_counts);
  use(d.indices.rotation_counts);
  use(d.against_faces);
  use(d.equal_curvatures);
  use(d.parallel_frames);
}

template <class Use>
void for_members(modes::TetJob& job, const Use& use) {
  use(job.tensors);
  use(job.tets);
  use(job.scale);
  use(job.level);
  use(job.limits);
}
template <class Use>
void for_members(modes::TetRecords& records, const Use& use) {
  use(records.signs);
  use(records.counts);
  use(records.tests);
}

std::map<Task, Skill> mesh_skills() {
  std::map<Task, Skill> r = face_skills();
  r.merge(std::map<Task, Skill>{{Task::curvatures, skill<curvature::Job>()},
                                {Task::ridge_fits, skill<ridges::FitJob>()},
                                {Task::ridge_decisions, skill<ridges::DecisionJob>()},
                                {Task::tet_tests, skill<modes::TetJob>()}});
  return r;
}

void use_ranks_for_meshes() {
  const auto pieces = static_cast<kernel::Index>(rank_count());
  static const curvature::Workers of_curvature = {
      pieces, by_ranks<curvature::Job, curvature::Records>(Task::curvatures)};
  static const modes::Workers of_modes = {
      pieces, by_ranks<modes::TetJob, modes::TetRecords>(Task::tet_tests)};
  static const ridges::Workers of_ridges = {
      pieces, by_ranks<ridges::FitJob, ridges::FitRecords>(Task::ridge_fits),
      by_ranks<ridges::DecisionJob, ridges::Decisions>(Task::ridge_decisions)};
  cli::mesh_workers() = {&of_curvature, &of_modes, &of_ridges, &workers_on_faces()};
}

}  // namespace crest::distributed
