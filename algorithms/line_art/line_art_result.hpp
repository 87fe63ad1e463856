// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A drawing: what is seen, and the strokes of the pen.
#include <string>

#include "algorithms/line_art/chains.hpp"

namespace crest::line_art {

struct Drawing {
  Scene scene;
  View view;
  Contours contours;
  DrawnContours lines;          ///< the contours' strokes
  std::vector<Stroke> hatches;  ///< in the order of painting
  std::string title, parameters;
};

}  // namespace crest::line_art
