// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A surface whose patches are told apart by tints.
#include <vector>

#include "io/picture/rasteriser.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

/// Twice the area times the normal, a face.
std::vector<kernel::Vec3> area_vectors(const kernel::TriangleMesh& mesh);

/// Each patch in a tint of its own, by its number modulo eight, shaded flat up to its edges.
/// Shapes: F numbers.
void draw_patches(Canvas& canvas, const Camera& camera, const kernel::TriangleMesh& mesh,
                  const std::vector<kernel::Index>& face_patch);

}  // namespace crest::io
