// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From where a drawing shows its scene, as a person says it.
#include <array>
#include <optional>

#include "algorithms/line_art/view.hpp"

namespace crest::io {

struct ViewChoice {
  std::optional<std::array<double, 2>> angles = {};  ///< azimuth, elevation, degrees
  std::optional<kernel::Vec3> up = {};
  std::optional<std::array<double, 6>> camera = {};  ///< eye, target
  std::optional<double> perspective = {};            ///< degrees
  double width = 160;                                ///< of the page, mm
};

/// What is not said is as the scene's shape asks for. Requires: the scene has points.
line_art::ViewRequest view_request(const ViewChoice& choice, const line_art::Scene& scene);

}  // namespace crest::io
