// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shaded pictures of a mesh with its ridges and umbilics, drawn in software.
#include <optional>
#include <string>

#include "algorithms/ridges/ridge_graph.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

struct Scene;  // io/page/scene.hpp

struct PictureOptions {
  int width = 1200;                  ///< pixels; the height follows from the view
  std::optional<kernel::Vec3> view;  ///< as in Viewpoint
  std::optional<kernel::Vec3> up = {};
  bool show_legend = true;
  int order = 4;  ///< types by the fourth-order or the third-order rule (3)
  /// By salience: dots at significant umbilics and regions, not where ridges end; lines smoothed
  /// and their spurs, up to `spur` long (units of the input), pruned (drawn_lines.hpp); segments
  /// below full_level a third as wide, and paler.
  bool by_salience = false;
  int full_level = 2;
  double spur = 0;
  std::string note;  ///< for the legend: that this is a subset of the graph, and why
};

/// Throws: kernel::InputError for another extension than .png and .svg, a width outside
///   [16, 16384], or a view or up that is no direction.
void check_picture(const std::string& path, const PictureOptions& options);

/// Writes .png or .svg, by the extension in any case, in the colours of paper 002: blue elliptic
/// blue, blue hyperbolic green, red elliptic red, red hyperbolic yellow; turning segments in
/// between, flat ones grey; umbilics at which a
/// ridge of the graph ends white (1-ridge), black (3-ridge) or grey (degenerate). Hidden
/// parts are not drawn. In .svg the surface is an embedded PNG, the ridges are paths.
/// Guarantees: the same bytes for the same input; no half-written file.
/// Throws: kernel::InputError for another extension, a width outside [16, 16384], a view or up that
/// is no direction, or
///   a place that cannot be written.
void write_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                   const ridges::RidgeGraph& graph, const PictureOptions& options = {});

/// The same for a page: ridges with their lengths, strengths, sharpnesses and what salience has
/// marked, umbilics with their indices, the surface with its curvatures.
Scene ridge_scene(const kernel::TriangleMesh& mesh, const ridges::FitResult& fit,
                  const ridges::RidgeGraph& graph, const PictureOptions& options);

}  // namespace crest::io
