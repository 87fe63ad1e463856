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

/// Shorter than 2.5 spacings; 0.8 are enough from contour to contour.
bool too_short(const Hatch& hatch, double spacing);

/// Along a silhouette lines would show as a row of dashes: within 0.6 spacings of a contour and
/// within 15 degrees of it, for more than half of their length; those of less than five spacings
/// within 0.8 and 26 degrees. What lies in the dark (luminance under 0.5) does not count.
bool hugs_contour(const Tracer& tracer, const Stroke& stroke);

/// Lines added to those there are: a new one starts at the spacing from an old one and stops at
/// 0.6 of it; `family`: ribs, or the crossing layer along backbones. Pixels darker than
/// `brightest` are hatched. Cost: linear in the points, for a bounded number of them a cell.
void add_even_streamlines(const Tracer& tracer, double brightest, Family family,
                          std::vector<Hatch>& lines);

/// What is still white though it is to be hatched: free ends go on, then lines are added that start
/// at 0.8 spacings from an old one; all stop at half a spacing, none at singularities, where the
/// field only turns. In the dark they start nearer to a contour, too. Cost: as above.
void fill_gaps(const Tracer& tracer, double brightest, Family family, std::vector<Hatch>& lines);

/// The thesis' first approach: seeds at random (always the same), each stroke over (1 - c) of its
/// length, none in highlights, those near silhouettes first.
std::vector<Hatch> random_streamlines(const Tracer& tracer, double brightest, double width);

}  // namespace crest::line_art
