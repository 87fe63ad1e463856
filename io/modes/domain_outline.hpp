// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The outline of a domain of tetrahedra, for pictures.
#include <array>
#include <vector>

#include "kernel/geometry/tet_mesh.hpp"

namespace crest::io {

/// Edges at which faces of the boundary meet at more than 30 degrees: segments, sorted by their
/// ends' numbers. To look at, decided in doubles.
std::vector<std::array<kernel::Vec3, 2>> domain_outline(const kernel::TetMesh& mesh);

}  // namespace crest::io
