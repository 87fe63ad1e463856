// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges as strokes and dots over their surface.
#include <vector>

#include "algorithms/ridges/ridge_graph.hpp"
#include "io/picture/drawing.hpp"
#include "io/ridges/ridge_lines.hpp"
#include "io/ridges/ridge_picture.hpp"

namespace crest::io {

/// Classes for ridges in the order of painting: red under blue, in each colour untyped (or flat),
/// hyperbolic, turning, elliptic.
std::vector<StrokeClass> ridge_classes();
inline constexpr std::size_t kRidgeClasses = 8;
std::size_t ridge_class(kernel::Colour colour, kernel::RidgeType type);

/// The same with thin, pale ones before them, for what is not salient.
std::vector<StrokeClass> classes_by_salience();

/// The graph's ridges as a picture with these options shows them. They refer to the graph.
std::vector<std::vector<LinePoint>> shown_lines(const kernel::TriangleMesh& mesh,
                                                const std::vector<kernel::Vec3>& normals,
                                                const ridges::RidgeGraph& graph,
                                                const PictureOptions& options);
/// Which of the classes the segment between two of its points takes.
std::size_t segment_class(const ridges::Ridge& ridge, const LinePoint& from, const LinePoint& to,
                          const PictureOptions& options);

/// The umbilics that a picture with these options shows.
std::vector<ridges::Umbilic> shown_umbilics(const ridges::RidgeGraph& graph,
                                            const PictureOptions& options);
/// The umbilic is no single one, but a region of umbilics.
bool is_region(const ridges::Umbilic& umbilic);
Rgb dot_colour(kernel::UmbilicKind kind);

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
