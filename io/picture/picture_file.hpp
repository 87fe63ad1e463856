// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pictures to files: .png, or .svg with the surface as an embedded PNG.
#include <string>

#include "io/picture/drawing.hpp"

namespace crest::io {

/// Throws: kernel::InputError for another extension than .png and .svg, in any case.
void check_picture_path(const std::string& path);

/// Writes the shaded surface on `canvas` with the drawing over it; in .svg strokes are paths.
/// Requires: check_picture_path. Guarantees: no half-written file.
/// Throws: kernel::InputError for a place that cannot be written.
void write_drawing(const std::string& path, const Camera& camera, Canvas& canvas,
                   const Drawing& drawing, bool show_legend);

/// Writes the canvas alone, of that size in pixels; the same otherwise.
void write_canvas(const std::string& path, const Canvas& canvas, int width, int height);

}  // namespace crest::io
