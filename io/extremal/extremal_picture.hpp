// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pictures of extremal surfaces, and of extremal curves over their image.
#include <string>

#include "algorithms/extremal/extremal_result.hpp"
#include "io/picture/viewpoint.hpp"
#include "kernel/geometry/sampled_grid.hpp"

namespace crest::io {

/// The surface coloured by plateness (red: 1, the paper's colour), its merely critical part grey,
/// edges of valence other than 2 as lines by their reason. Requires: dimension 3, a polygon at
/// least. Throws: kernel::InputError for another extension than .png and .svg, a place that cannot
/// be written or a direction that is none.
void write_extremal_picture(const std::string& path, const extremal::Result& result,
                            const Viewpoint& viewpoint = {});

/// Extremal curves red, merely critical ones blue, over the image they are of, in its world.
void write_extremal_picture(const std::string& path, const extremal::Result& result,
                            const kernel::SampledGrid& image);

struct Scene;  // io/page/scene.hpp

/// The same for a page; `image`: of a result of dimension 2.
Scene extremal_scene(const extremal::Result& result, const kernel::SampledGrid* image,
                     const Viewpoint& viewpoint);

}  // namespace crest::io
