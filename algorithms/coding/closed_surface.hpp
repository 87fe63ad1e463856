// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A surface whose boundary loops are closed, each by a fan of triangles around an extra vertex.
#include <array>
#include <vector>

#include "algorithms/coding/surface.hpp"

namespace crest::coding {

/// Half-edge h = 4 f + k starts at corner k of face f; the surface's faces come first. Vertex
/// `vertices` + i closes loop i. What is asked of a face stands in half a cache line.
struct ClosedSurface {
  struct alignas(32) Face {
    std::array<Index, 4> origin, twin;  ///< of half-edges; the last ones are not used
  };

  /// Throws: InputError if there are 2^29 triangles or more.
  explicit ClosedSurface(const Surface& surface);

  static Index next(Index h) { return (h & 3) == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return (h & 3) == 0 ? h + 2 : h - 1; }
  Index from(Index h) const { return list[h / 4].origin[h % 4]; }
  Index twin(Index h) const { return list[h / 4].twin[h % 4]; }
  Index& twin(Index h) { return list[h / 4].twin[h % 4]; }
  bool extra(Index v) const { return v >= vertices; }

  Index vertices, faces;  ///< without the extra ones
  std::vector<Face> list;
  std::vector<Index> valence;  ///< of vertices, extra ones too
  std::vector<Index> starts;   ///< a half-edge a component; from an extra vertex if it has one
};

}  // namespace crest::coding
