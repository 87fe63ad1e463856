// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangles glued along equal sides, whichever way the two run along it.
#include "certify/container/buffer.hpp"
#include "certify/surface/corners.hpp"

namespace crest::certify {

struct Gluing {
  Buffer<std::uint32_t> twin;                  ///< 3F: the other side, kNone at the boundary
  Buffer<std::uint32_t> edge_of;               ///< 3F, if asked for
  Buffer<std::array<std::uint32_t, 2>> edges;  ///< E, lexicographic, if asked for
  std::size_t edge_count = 0;
  bool aligned = true;  ///< the two run along no side in the same direction
};

/// Throws Reject: an index without vertex, a corner twice, three triangles at an edge, two with the
/// same corners. Cost: linear, plus the sorting of each vertex's edges.
Gluing glue(Faces faces, std::size_t vertices, bool with_edges);

}  // namespace crest::certify
