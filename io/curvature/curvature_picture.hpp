// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shaded pictures of a mesh: coloured by a number at each vertex, or with its focal surfaces.
#include <optional>
#include <string>
#include <vector>

#include "algorithms/curvature/focal.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

struct ColourPicture {
  std::string label;                 ///< under the picture
  int width = 1200;                  ///< pixels
  std::optional<kernel::Vec3> view;  ///< as in Viewpoint
  std::optional<kernel::Vec3> up = {};
  double stroke = 0;  ///< width of focal curves, pixels; 0: a 2000th of the width, at least 0.5
};

/// Writes .png, or .svg with the PNG embedded. Blue for negative, white for zero, red for positive
/// values; the ends of the map are the 95 % quantile of the absolute values, which the bar below
/// names.
/// Requires: one value a vertex.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_colour_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                          const std::vector<double>& values, const ColourPicture& options);

/// Writes .png or .svg as above: the boundary curves of a focal surface over the shaded mesh, green
/// where the curvature is positive, red where it is negative (paper 001, figures 3.7, 3.8, 3.11,
/// 3.12). Curves behind the mesh are hidden; they do not hide one another.
void write_focal_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                         const curvature::FocalSurface& focal, const ColourPicture& options);

struct Scene;  // io/page/scene.hpp

/// A page of the mesh with all curvatures, `shown` (a name among H, K, k1, k2) first, and the
/// boundary curves of focal surfaces.
Scene curvature_scene(const kernel::TriangleMesh& mesh, const curvature::Result& result,
                      const std::string& shown, const std::vector<curvature::FocalSurface>& focal,
                      const ColourPicture& options);

}  // namespace crest::io
