// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a user says about parts of the page, put into the frame buffer.
#include "algorithms/line_art/buffers.hpp"
#include "algorithms/line_art/line_art_result.hpp"

namespace crest::line_art {

/// Directions and luminance of each region's pixels; without rings a region is all of the page.
void steer(const std::vector<Region>& regions, Buffers& buffers);

/// The point of the bilinear Coons patch at (u, v) and its derivative along u. Requires: curves
/// below, right, above and left of at least two points, the first two running right and up, as do
/// the others.
struct CoonsPoint {
  Vec2 place, along_u;
};
CoonsPoint coons_point(const std::array<std::vector<Vec2>, 4>& curves, double u, double v);

}  // namespace crest::line_art
