// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Hatches on the page: none meets a visible contour, each starts on its face (SPEC.md, step 5).
#include <vector>

#include "certify/lineart/contours.hpp"

namespace crest::certify {

/// Throws: Reject unless the page map has full rank and every hatch is as stated.
/// Cost: what boxes leave, in rationals.
void check_hatches(const LineArtCertificate& c, const std::vector<FoundEdge>& edges);

/// Throws: Reject unless the view's numbers make a page map, and in perspective all points are
/// strictly in front of the eye.
void check_view(const LineArtCertificate& c);

}  // namespace crest::certify
