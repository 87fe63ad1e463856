// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is left out of a surface: faces and vertices. Each returns how many; the order of what stays
// is kept.
#include "io/clean/sides.hpp"

namespace crest::io {

/// Keeps the faces with a mark.
void keep_faces(Surface& surface, const std::vector<bool>& kept);

/// Faces that have a vertex twice.
std::size_t drop_repeated_corners(Surface& surface);

/// Faces with the three vertices of an earlier one, whichever way round.
/// Requires: the surface's sides, no repeated corners.
std::size_t drop_duplicates(Surface& surface, const std::vector<Side>& sides);

/// Vertices of no face; those of curved faces beside their corners go uncounted. Renumbers the
/// rest.
std::size_t drop_unused(Surface& surface);

}  // namespace crest::io
