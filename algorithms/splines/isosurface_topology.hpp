// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What an isosurface's mesh is as a surface.
#include <span>

#include "algorithms/splines/isosurface.hpp"

namespace crest::splines {

using MeshEdge = std::array<kernel::Index, 2>;

/// Fills in Euler characteristic, components, boundary loops, coincident vertices. `border`: the
/// sides of triangles that have one triangle. Requires: all others have two, as those of marching
/// tetrahedra on a complex.
void describe(Isosurface& mesh, std::span<const MeshEdge> border);

}  // namespace crest::splines
