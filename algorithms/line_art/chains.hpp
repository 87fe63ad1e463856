// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Contours as an illustrator draws them: visible pieces joined to long lines, gaps bridged,
// smoothed within half a line width, tapered where they end freely.
#include "algorithms/line_art/contours.hpp"
#include "algorithms/line_art/stroke.hpp"

namespace crest::line_art {

struct ChainOptions {
  double line_width = 0.35;  ///< mm
};

struct DrawnContours {
  std::vector<Stroke> strokes;
  /// Visible pieces that are no ink: chains that are too short.
  std::size_t suppressed = 0;
  double suppressed_length = 0, visible_length = 0;  ///< mm
};

/// Nothing of what is drawn is hidden but by smoothing and bridging, which stay within 1.3 widths.
DrawnContours draw_contours(const Scene& scene, const View& view, const Contours& contours,
                            const ChainOptions& options = {});

}  // namespace crest::line_art
