// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/degenerate_faces.hpp"
#include "distributed/messages.hpp"
#include "distributed/systems.hpp"

namespace crest::distributed {

template <class Use>
void for_members(modes::FaceJob& job, const Use& use) {
  use(job.tensors);
  use(job.tets);
}
template <class Use>
void for_members(modes::FaceRecords& records, const Use& use) {
  use(records.excluded);
  use(records.stages);
  use(records.kept);
  use(records.roots);
}

std::map<Task, Skill> face_skills() {
  return {{Task::face_tests, skill<modes::FaceJob>()}};
}

const modes::FaceWorkers& workers_on_faces() {
  static const modes::FaceWorkers workers = {
      static_cast<kernel::Index>(rank_count()),
      by_ranks<modes::FaceJob, modes::FaceRecords>(Task::face_tests)};
  return workers;
}

}  // namespace crest::distributed
