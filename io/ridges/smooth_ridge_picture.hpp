// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shaded pictures of a smooth surface with its ridges, umbilics, turning and purple points.
#include <string>

#include "algorithms/smooth_ridges/smooth_ridges_result.hpp"
#include "io/ridges/ridge_picture.hpp"

namespace crest::io {

/// Writes .png or .svg in the colours of write_picture(). Umbilics are white (1-ridge) or black
/// (3-ridge), disks of index +1/2, triangles of index -1/2; turning points diamonds in the
/// turning colour of their ridge, purple points purple ones. Faces that are not certified are
/// tinted red and the legend says so. Hidden parts are not drawn.
/// options.order is not used.
/// Guarantees: the same bytes for the same result; no half-written file.
/// Throws: kernel::InputError as write_picture() does.
void write_smooth_picture(const std::string& path, const smooth_ridges::SmoothRidges& result,
                          const PictureOptions& options = {});

struct Scene;  // io/page/scene.hpp

/// The same for a page.
Scene smooth_ridge_scene(const smooth_ridges::SmoothRidges& result, const PictureOptions& options);

}  // namespace crest::io
