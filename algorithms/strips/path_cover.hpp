// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Strips as paths of faces: a choice of links between neighbouring faces, at most two a face.
#include <cstdint>
#include <vector>

#include "kernel/geometry/corner_table.hpp"

namespace crest::strips {

using kernel::CornerTable;
using kernel::Index;

/// Bit k of links[f]: face f is joined over its side k with the neighbour there, which has the bit
/// of its own side. Shapes: F.
using Links = std::vector<std::uint8_t>;

/// A face's place in a path: the half-edges over which the path comes and goes; kNone at its ends.
struct Step {
  Index face, entry, exit;
};
using Path = std::vector<Step>;

/// Simulated annealing: a sweep tries to toggle every link; where a face would get three, one of
/// the others goes. The energy is the number of vertices sent less a constant: two a path and
/// `swap_cost` for two equal turns in a row (thesis 4.4.1: a swap vertex).
/// Guarantees: integers only and a fixed seed, so the same links everywhere.
/// Cost: O(F) a sweep.
void anneal(const CornerTable& mesh, Links& links, int sweeps, int swap_cost);

/// The paths of the links, each face in one; cycles are cut where that costs least. In the order of
/// their first faces' numbers.
std::vector<Path> paths_of(const CornerTable& mesh, Links links);

/// The same path from its other end.
Path reversed(const Path& path);

}  // namespace crest::strips
