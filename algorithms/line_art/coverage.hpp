// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What hatches cover of the page, and what part of it each of their points answers for.
#include "algorithms/line_art/streamlines.hpp"

namespace crest::line_art {

/// The page's part and length that belong to every vertex of every hatch: pixels nearer to it than
/// to any other, not across contours nor farther than `reach`.
struct OwnedArea {
  std::vector<std::vector<double>> area, spacing;  ///< mm^2; area over length, mean over 2 mm
  /// Whose a pixel is: hatch (kNone: nobody's) and vertex.
  std::vector<std::pair<Index, Index>> owner;
};
OwnedArea owned_area(const Buffers& buffers, const std::vector<Hatch>& hatches, double reach);

/// How much of every pixel is black, 0 to 1, once the strokes' outlines are painted in their order:
/// of 16 samples, so ink under ink counts once.
std::vector<float> coverage(const Buffers& buffers, const std::vector<Hatch>& hatches);

/// Of every point of a line: half of the adjacent segments.
std::vector<double> owned_lengths(const std::vector<Vec2>& line);

/// Sums of `top` over sums of `bottom`, over a window of the given length along the line.
std::vector<double> mean_ratio(const std::vector<double>& top, const std::vector<double>& bottom,
                               const std::vector<double>& length, double window);

}  // namespace crest::line_art
