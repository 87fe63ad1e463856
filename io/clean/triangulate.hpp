// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From a soup's cells to triangles: polygons and strips are cut, cells of other dimensions left
// out.
#include "io/clean/clean_up.hpp"
#include "io/clean/surface.hpp"

namespace crest::io {

/// The corners of one cell of dimension 2, in the order of a polygon; cells of higher order give
/// their corners without the nodes between them.
/// Throws: kernel::InputError for a type without a rule here, or too few nodes for the type.
std::vector<kernel::Index> corners_of(const Soup& soup, std::size_t cell);

/// All points become vertices, all cells of dimension 2 triangles in their order: polygons by the
/// rule of PolygonCutter, strips as they run. Of fewer than 3 corners: counted as repeated ones.
/// `curved`: 6-node triangles keep their mid-side nodes.
/// Throws: kernel::InputError without faces, for nodes that do not exist, for polygons with points
/// that are not finite, and as corners_of.
Surface triangulate(const Soup& soup, bool curved, CleanUp& done);

}  // namespace crest::io
