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

/// The mesh as it is decoded, and where it comes from.
struct CodedOrder {
  std::vector<Triangle> faces;  ///< decoded
  std::vector<Index> corners;   ///< of each: the mesh's half-edge that starts at its first corner
  Index splits = 0;  ///< triangles that join two parts of a boundary or two boundaries
};

}  // namespace crest::coding
