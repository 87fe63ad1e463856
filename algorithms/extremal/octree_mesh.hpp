// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The dual mesh over an octree: polygons over minimal edges with the 3 or 4 leaves round them,
// groups of critical edges on minimal faces with all edges of their borders.
#include "algorithms/extremal/extremal_result.hpp"
#include "algorithms/extremal/point_nodes.hpp"
#include "algorithms/extremal/sheet_mesh.hpp"

namespace crest::extremal {

/// Counts odd, ambiguous and junction faces, too.
SheetMesh make_octree_sheets(const PointTree& tree, bool critical, Counts& counts);

}  // namespace crest::extremal
