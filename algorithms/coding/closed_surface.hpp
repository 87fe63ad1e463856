// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A surface whose boundary loops are closed, each by a fan of triangles around an extra vertex.
#include <vector>

#include "algorithms/coding/surface.hpp"

namespace crest::coding {


/// Half-edges as Surface numbers them; those of the surface come first. Vertex
/// `vertices` + i closes loop i.
struct ClosedSurface {
  explicit ClosedSurface(const Surface& surface);

  Index from(Index h) const { return origin[h]; }
  bool extra(Index v) const { return v >= vertices; }

  Index vertices, faces;             ///< without the extra ones
  std::vector<Index> origin, twin;   ///< of half-edges
  std::vector<Index> valence;        ///< of vertices, extra ones too
  std::vector<Index> starts;         ///< a half-edge a component; from an extra vertex if it has one
};

}  // namespace crest::coding
