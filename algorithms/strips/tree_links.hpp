// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The strips that a strip tree has already (thesis 4.4.1).
#include <span>

#include "algorithms/strips/path_cover.hpp"

namespace crest::strips {

/// Every node's strip goes on into one of its children: the one to which its last turn makes it
/// alternate, else, with a swap, the other. A node of length 1 has the turn of the strip that
/// enters it before it. Guarantees: on spheres and discs the strips of these links send at most t +
/// v - 1 vertices, three
///   more for a closed component (thesis 4.4.1).
/// Cost: O(F).
Links tree_links(const CornerTable& mesh, std::span<const kernel::Triangle> faces);

}  // namespace crest::strips
