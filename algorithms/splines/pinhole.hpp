// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A pinhole camera: a ray a pixel.
#include <optional>

#include "algorithms/splines/rays.hpp"

namespace crest::splines {

struct Pinhole {
  Vec3 eye{}, target{};
  double angle = 40;  ///< vertical, in degrees
  int width = 512, height = 512;

  /// To the right, up and forward, unit vectors; up is as near to z as may be, or to y for a view
  /// along z.
  struct Axes {
    Vec3 right, up, forward;
  };
  Axes axes() const;
  /// Through the pixels' centres, row by row from the upper left. Their directions have length 1 or
  /// somewhat more.
  std::vector<Ray> rays() const;
};

/// A view of the whole domain from the right, the front and above.
Pinhole automatic_view(const QuadraticSpline& spline, int size);

}  // namespace crest::splines
