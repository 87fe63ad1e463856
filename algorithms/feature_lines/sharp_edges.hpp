// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sharp edges: those whose faces' normals make an angle above a given one, exactly, and their
// graph; and for noisy meshes the same angle between normals averaged over rings, as a field.
#include "algorithms/feature_lines/feature_graph.hpp"
#include "kernel/predicates/dihedral_angle.hpp"

namespace crest::feature_lines {

struct SharpOptions {
  Index prune = 0;           ///< lines with an open end of at most so many vertices vanish
  Index close_branches = 0;  ///< longest gap closed between two open ends, in edges
};

struct SharpLines {
  Marks sharp;         ///< E: the angle is above the given one
  Marks edges;         ///< E: the result, after pruning and joining
  FeatureGraph graph;  ///< of `edges`
  Index ties = 0;      ///< edges with exactly that angle: not sharp
  Index pruned = 0;    ///< lines that vanished
  Index joined = 0;    ///< pairs of open ends joined
  kernel::StageCounts decided;
};

/// The edges with an angle above `angle` (kernel/predicates/dihedral_angle.hpp). Edges with one
/// face have no angle and are not sharp.
/// Cost: O(E), about 0.2 microseconds an edge.
SharpLines extract_sharp_lines(const kernel::TriangleMesh& mesh, const kernel::DecimalAngle& angle,
                               const SharpOptions& options);

/// At each vertex the largest angle, in degrees, at the edges that meet there; rounded. An edge's
/// angle is that between the sums of the area vectors (half the cross product of two sides) on its
/// two sides: of its own two faces for rings = 0; else of the faces with a corner at most rings - 1
/// edges from one of its ends, parted by the plane that holds the edge's middle, its direction and
/// the sum of all these vectors, a face to the side of its barycentre; those in the plane count on
/// neither side. 0 for an edge with one face, or without a face on one side.
/// Cost: O(E) times the faces within `rings`.
std::vector<double> vertex_angles(const kernel::TriangleMesh& mesh, Index rings);

}  // namespace crest::feature_lines
