// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the figures of paper 001, section 3.5, are drawn from.
#include <optional>
#include <string>

#include "algorithms/line_art/line_art.hpp"

namespace crest::experiments {

/// Principal directions by the default method.
std::vector<line_art::PrincipalFrame> frames_of(const kernel::TriangleMesh& mesh);

/// The scene, its view from a direction and the contours with their strokes.
line_art::Drawing contour_drawing(const kernel::TriangleMesh& mesh, const line_art::Vec3& eye,
                                  double width);

}  // namespace crest::experiments
