// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A shaded picture of a mesh, coloured by a number at each vertex.
#include <optional>
#include <string>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::io {

struct ColourPicture {
  std::string label;                 ///< lower case, under the picture
  int width = 1200;                  ///< pixels
  std::optional<kernel::Vec3> view;  ///< from the eye into the scene; nothing: chosen
};

/// Writes .png, or .svg with the PNG embedded. Blue for negative, white for zero, red for positive
/// values; the ends of the map are the 95 % quantile of the absolute values, which the bar below
/// names.
/// Requires: one value a vertex.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_colour_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                          const std::vector<double>& values, const ColourPicture& options);

}  // namespace crest::io
