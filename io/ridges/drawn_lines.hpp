// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges as a picture by salience shows them; the graph and what -o writes stay as they are.
#include <vector>

#include "io/ridges/ridge_lines.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// The ridges' lines with their zigzags smoothed: 32 steps of the means of neighbours, each kept in
/// the tangent plane at its crossing. Points inside patches and the ends of a line stay. Spurs are
/// marked: what at an open end (of the points of level 1, then of those of full_level) is no longer
/// than `spur` and turns off by more than 60 degrees; loops smaller than `spur`. Open: cut, or at
/// an umbilic that a picture by salience does not show and where no other ridge of the colour ends.
/// A loop may begin at another of its points.
/// Shapes: normals of vertices; a line for each ridge. They refer to the graph.
std::vector<std::vector<LinePoint>> drawn_lines(const kernel::TriangleMesh& mesh,
                                                const std::vector<kernel::Vec3>& normals,
                                                const ridges::RidgeGraph& graph, double spur,
                                                int full_level);

}  // namespace crest::io
