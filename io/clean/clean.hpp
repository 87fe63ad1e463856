// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From what a file holds to a surface: the steps of the cleaning in their order.
#include "io/clean/clean_up.hpp"
#include "io/clean/surface.hpp"

namespace crest::io {

enum class Purpose {
  geometry,      ///< an oriented manifold without faces of area zero
  connectivity,  ///< an oriented manifold: areas play no part
  function  ///< a manifold that carries values: one-sided parts, faces of area zero and mid-side
            ///< nodes stay, since nothing of the values may be lost
};

/// In this order: polygons become triangles (PolygonCutter), faces with repeated corners and
/// vertices that nothing uses are left out, vertices are welded if asked for, duplicate faces left
/// out, edges of three or more faces cut if asked for, vertices of several fans split; for geometry
/// one-sided parts are cut if asked for, minorities turned, closed parts turned outward if asked
/// for, faces of area zero collapsed.
/// Guarantees: every vertex is used, has one fan and is finite; every edge is in one or two faces;
/// no two faces have the same vertices; vertices and faces keep the file's order, but split
/// vertices come last. A surface that is clean already is not changed. Throws: kernel::InputError
/// in the file's numbers for what must not be mended without being asked for, naming the option
/// that does, or cannot be mended. Cost: O(n log n).
Surface clean(const Soup& soup, const CleanOptions& options, Purpose purpose, CleanUp& done);

}  // namespace crest::io
