// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Other meshes of the same surface, by CGAL.
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::experiments {

/// Edges collapsed, cheapest first (Lindstrom and Turk), until half of them are left.
kernel::TriangleMesh decimated(const kernel::TriangleMesh& mesh);

/// Isotropic remeshing (Botsch and Kobbelt), three rounds to the mean edge length.
kernel::TriangleMesh remeshed(const kernel::TriangleMesh& mesh);

}  // namespace crest::experiments
