// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The isosurface that a camera's rays hit, shaded by the spline's gradients.
#include <span>
#include <string>

#include "algorithms/splines/pinhole.hpp"
#include "io/picture/rasteriser.hpp"

namespace crest::io {

/// One pixel a hit, in the order of Pinhole::rays, the upper left one of these at (left, top).
/// `tints`: factors on red, green and blue from 0 to 1, one a ray, or none.
void draw_rays(Canvas& canvas, int left, int top, const splines::Pinhole& camera,
               std::span<const splines::Hit> hits, std::span<const kernel::Vec3> tints = {});

/// Requires: check_picture_path. Guarantees: no half-written file. Throws: kernel::InputError for a
/// place that cannot be written.
void write_ray_picture(const std::string& path, const splines::Pinhole& camera,
                       std::span<const splines::Hit> hits);

}  // namespace crest::io
