// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The pieces of a parallel file as one soup.
#include <vector>

#include "io/formats/soup.hpp"

namespace crest::io {

/// Points of several pieces with the same coordinates are one, that of the first piece, unless a
/// piece has two there (a seam or a crack: such points stay apart, a warning counts them). Else
/// points and cells are in the order of the pieces, and numbered by it. Fields are those that all
/// pieces with points, or with cells, have. Throws where a cell names a point that its piece lacks
/// and where a field's type changes.
Soup join(std::vector<Soup> pieces);

/// Leaves out cells that VTK's array vtkGhostType says are another piece's or hidden, with a
/// warning, and the array.
void leave_out_ghosts(Soup& soup);

}  // namespace crest::io
