// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Who works on pieces of meshes: this process, on all of each, unless the program sets others.
namespace crest::curvature {
struct Workers;
}
namespace crest::modes {
struct FaceWorkers;
struct Workers;
}  // namespace crest::modes
namespace crest::ridges {
struct Workers;
}

namespace crest::cli {

struct MeshWorkers {
  const curvature::Workers* curvature = nullptr;
  const modes::Workers* modes = nullptr;
  const ridges::Workers* ridges = nullptr;
  const modes::FaceWorkers* faces = nullptr;  ///< of degenerate curves
};
inline MeshWorkers& mesh_workers() {
  static MeshWorkers workers;
  return workers;
}

}  // namespace crest::cli
