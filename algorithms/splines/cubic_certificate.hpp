// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is proven of a cubic spline (claim 12, certify/spline_cubic/SPEC.md).
#include <span>

#include "algorithms/splines/cubic_model.hpp"

namespace crest::certify {
struct SplineCubicCertificate;
}

namespace crest::splines {

/// By how much the gradient may jump inside cubes, where the 14 numbers leave it free.
struct GradientJump {
  double bound = 0;  ///< no gradient jumps by more, in the world's units; 0: the spline is C1
  Vec3 where{};      ///< the centre of the cube with the largest residual
};
GradientJump gradient_jump(const CubicModel& model);

/// `max_error`, as evaluate() has it, rounded up to what holds of the spline itself.
double error_bound(const CubicModel& model, double max_error);

/// Of the samples in the closed box; the others are counted.
certify::SplineCubicCertificate cubic_certificate(const CubicModel& model,
                                                  std::span<const Vec3> points,
                                                  std::span<const double> values, double max_error);

}  // namespace crest::splines
