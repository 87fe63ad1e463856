// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Loop's subdivision by CGAL, for parts that the public has only as coarse meshes.
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::experiments {

/// Every face into four, vertices smoothed. Throws: std::runtime_error where CGAL refuses a face.
kernel::TriangleMesh loop_subdivision(const kernel::TriangleMesh& mesh);

}  // namespace crest::experiments
