// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scene of a drawing: any triangles, equal points welded, with the faces at every edge.
#include <array>
#include <vector>

#include "kernel/geometry/index.hpp"
#include "kernel/predicates/sight.hpp"

namespace crest::line_art {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;
using kernel::Vec3;

/// Points that faces use, each place once, in the order of the input's vertices. Faces that lost a
/// corner are gone; the others keep their order. Nothing else is required of them.
struct Scene {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  std::vector<Index> input_vertex;  ///< the first at each place
  std::vector<Index> input_face;
};

/// Requires: indices below points.size(). Throws: kernel::InputError for used coordinates that are
/// not finite and for a scene without faces. Cost: O(V + F) expected.
Scene weld(const std::vector<Vec3>& points, const std::vector<Triangle>& faces);

/// A corner of a face, seen from the edge opposite.
struct EdgeSide {
  Index face, opposite;
};

/// All edges, ascending by (low, high), with their faces in the faces' order.
struct SceneEdges {
  struct Edge {
    Index low, high, begin, end;  ///< in sides
  };
  std::vector<Edge> edges;
  std::vector<EdgeSide> sides;
};
SceneEdges edges_of(const Scene& scene);

}  // namespace crest::line_art
