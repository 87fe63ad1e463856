// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What all methods of coding a connectivity share.
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/geometry/index.hpp"

namespace crest::coding {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;

/// What the header says of a mesh.
struct Counts {
  Index vertices = 0, components = 1, loops = 0, handles = 0;
  bool operator==(const Counts&) const = default;
};

/// Where the mesh's vertices and faces stand in the decoded mesh's order.
struct CodedOrder {
  std::vector<Index> vertices;  ///< the mesh's vertex at each decoded one
  std::vector<Index> corners;   ///< the mesh's half-edge from each decoded face's first corner
};

}  // namespace crest::coding
