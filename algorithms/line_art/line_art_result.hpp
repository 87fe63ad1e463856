// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A drawing: what is seen, and the strokes of the pen.
#include <string>

#include "algorithms/line_art/chains.hpp"

namespace crest::line_art {

struct ToneError {
  double mean = 0, p95 = 0, max = 0;  ///< of luminance in cells of five spacings
  std::size_t cells = 0;
};

struct HatchCounts {
  std::size_t singularities = 0;
  double index_sum = 0;  ///< of the field, on the whole surface
  std::size_t segments = 0, key_ribs = 0, blended = 0;
  double length = 0;                    ///< mm
  double p5 = 0, median = 0, p95 = 0;   ///< spacing, mm
  double median_length = 0;             ///< of strokes, mm
  double bare = 0;                      ///< share of what is to be hatched beyond the spacing
  std::size_t over_contours = 0;        ///< strokes that come within a nanometre of a contour
  ToneError tone;
};

struct Drawing {
  Scene scene;
  View view;
  Contours contours;
  DrawnContours lines;          ///< the contours' strokes
  std::vector<Stroke> hatches;  ///< in the order of painting
  HatchCounts counts;           ///< of the hatches
  std::string title, parameters;
};

}  // namespace crest::line_art
