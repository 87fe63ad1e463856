// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What needs no cleaning: most files.
#include <optional>

#include "io/clean/clean_up.hpp"
#include "io/formats/soup.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// The soup's triangles as a mesh, if clean() for geometry would change nothing: the mesh's own
/// check of manifolds is the only one then. Fails where there is anything to mend, and to be said.
/// `done` gets the counts of what clean() only sees. Cost: O(n).
std::optional<kernel::TriangleMesh> sound_mesh(const Soup& soup, const CleanOptions& options,
                                               CleanUp& done);

}  // namespace crest::io
