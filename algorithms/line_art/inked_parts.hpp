// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the pen draws of the visible pieces: those that coincide on the page once.
#include "algorithms/line_art/contours.hpp"

namespace crest::line_art {

/// A part of a visible piece, from t to t on its edge.
struct InkedPart {
  Index edge, piece;  ///< piece: of the edge's, from 0
  double from, to;
  bool whole_from, whole_to;  ///< does it end where the piece does
};

/// Ascending by edge. That two edges lie on one line of the page, as the points are, is decided
/// exactly; where one covers the other it is inked as the first of them, creases last. The ends
/// of what is left are places on the page, in double.
std::vector<InkedPart> inked_parts(const Scene& scene, const View& view, const Contours& contours);

}  // namespace crest::line_art
