// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Approach 1: stream lines, evenly spaced on the page (after Jobard and Lefer) or at random seeds.
#include "algorithms/line_art/stroke.hpp"
#include "algorithms/line_art/tracer.hpp"

namespace crest::line_art {

/// A hatch with how its ends are.
struct Hatch {
  Stroke stroke;
  bool free_start = true, free_end = true;  ///< neither at a contour
};

/// A new line starts at the spacing from an old one and stops at half of it. Cost: linear in the
/// points, for a bounded number of them a cell.
std::vector<Hatch> even_streamlines(const Tracer& tracer, double brightest);

/// The thesis' first approach: seeds at random (always the same), each stroke over (1 - c) of its
/// length, none in highlights, those near silhouettes first.
std::vector<Hatch> random_streamlines(const Tracer& tracer, double brightest, double width);

}  // namespace crest::line_art
