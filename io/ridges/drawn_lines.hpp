// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges as a picture by salience shows them; the graph and what -o writes stay as they are.
#include <vector>

#include "io/ridges/ridge_lines.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// The ridge's line with its zigzag smoothed: 32 steps of the means of neighbours, each kept in the
/// tangent plane at its crossing. Points inside patches and the ends of a line stay. Spurs are
/// marked: what at a cut end (of the points of level 1, then of those of full_level) is no longer
/// than `spur` and turns off by more than 60 degrees. A loop may begin at another of its points.
/// Shapes: normals of vertices.
std::vector<LinePoint> drawn_line(const kernel::TriangleMesh& mesh,
                                  const std::vector<kernel::Vec3>& normals,
                                  const ridges::Ridge& ridge, double spur, int full_level);

}  // namespace crest::io
