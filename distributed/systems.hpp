// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the systems do by all ranks.
#include "distributed/ranks.hpp"

namespace crest::modes {
struct FaceWorkers;
}

namespace crest::distributed {

/// Volumes: each rank reads what its blocks need, halo and all, from the file itself.
std::map<Task, Skill> volume_skills();
void use_ranks_for_volumes();

/// Degenerate curves, apart: two headers of modes have a Tensor each.
std::map<Task, Skill> face_skills();
const modes::FaceWorkers& workers_on_faces();

/// Meshes: rank 0 reads them and sends each rank its pieces, halo and all.
std::map<Task, Skill> mesh_skills();
void use_ranks_for_meshes();

}  // namespace crest::distributed
