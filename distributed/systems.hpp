// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the systems do by all ranks.
#include "distributed/ranks.hpp"

namespace crest::distributed {

/// Volumes: each rank reads what its blocks need, halo and all, from the file itself.
std::map<Task, Skill> volume_skills();
void use_ranks_for_volumes();

/// Meshes: rank 0 reads them and sends each rank its pieces, halo and all.
std::map<Task, Skill> mesh_skills();
void use_ranks_for_meshes();

}  // namespace crest::distributed
