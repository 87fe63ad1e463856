// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges as strokes and dots over their surface.
#include <vector>

#include "algorithms/ridges/ridge_graph.hpp"
#include "io/picture/drawing.hpp"
#include "io/ridges/ridge_picture.hpp"

namespace crest::io {

/// Classes for ridges in the order of painting: red under blue, in each colour untyped (or flat),
/// hyperbolic, turning, elliptic.
std::vector<StrokeClass> ridge_classes();
std::size_t ridge_class(kernel::Colour colour, kernel::RidgeType type);

/// How much of the elliptic ridges faces the eye, weighted by curvature; nothing without ridges.
/// Refers to what it is given.
ViewScore view_score(const kernel::TriangleMesh& mesh, const std::vector<kernel::Vec3>& normals,
                     const ridges::RidgeGraph& graph);

/// Cuts the ridges where the canvas's surface hides them. Strokes and dots become thinner where
/// there are too many for the picture.
Drawing make_drawing(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
                     const std::vector<kernel::Vec3>& normals, const ridges::RidgeGraph& graph,
                     const PictureOptions& options);

}  // namespace crest::io
