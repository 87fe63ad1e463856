// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The models that section 8.6.3 compares quadratic super splines with: plain interpolation of a
// volume's samples. Places and gradients are in units of samples: sample v lies at v.
// Requires: 3D grids with three samples or more along each axis; places between the outermost
// samples, of the triquadratic model half a spacing inside these.
#include "algorithms/splines/quadratic.hpp"

namespace crest::splines {

/// Linear on the type-6 partition of the cubes between samples: centres of faces and cubes have the
/// means of their corners.
ValueAndGradient linear_on_partition(const kernel::SampledGrid& grid, const Vec3& v);

/// Continuous and quadratic on Freudenthal's partition of cubes of side 2, which interpolates their
/// 27 samples; beyond the last whole cube that cube's.
ValueAndGradient freudenthal_quadratic(const kernel::SampledGrid& grid, const Vec3& v);

/// Trilinear; the gradient is the model's own, or the samples' central differences interpolated
/// alike.
ValueAndGradient trilinear(const kernel::SampledGrid& grid, const Vec3& v);
ValueAndGradient trilinear_differences(const kernel::SampledGrid& grid, const Vec3& v);

/// Tensor products of quadratic B-splines with the samples as coefficients.
ValueAndGradient triquadratic(const kernel::SampledGrid& grid, const Vec3& v);

}  // namespace crest::splines
